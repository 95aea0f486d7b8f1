// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <CLI/CLI.hpp>
#include <cstdint>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "commands/commands.h"
#include "exit_codes.h"
#include "mesh_files.h"
#include "option_numbers.h"
#include "report/console.h"
#include "report/losses.h"
#include "report/progress.h"
#include "scenes/drive.h"
#include "scenes/scenes.h"
#include "sequence/sequence.h"

namespace deltamesh::cli {
namespace {

struct GenerateArguments {
  std::string scene;
  std::string out;
  std::uint64_t vertices = 50'000;
  std::uint64_t seed = 1;
  std::string sequence;
  std::uint32_t steps = 50;
};

Result<Mesh> generate_showing_progress(const GenerateArguments& arguments) {
  const Progress progress("generating");
  return generate_scene(*scene_of_name(arguments.scene), arguments.vertices, arguments.seed);
}

SequenceHeader header_of(const Drive& drive, std::uint64_t seed) {
  return {.description =
              "generated drive through rooms, seed " + std::to_string(seed) + ", an update every 0.2 s",
          .voxel = drive.voxel(),
          .block_voxels = kDriveBlockVoxels,
          .block_metres = kDriveBlockVoxels * drive.voxel(),
          .origin = drive.origin()};
}

/// Writes `arguments.steps` updates of a drive through rooms as a folder.
int write_drive(const GenerateArguments& arguments) {
  const std::string& folder = arguments.sequence;
  auto drive = Drive::make(arguments.vertices, arguments.seed);
  if (!drive) return fail("--vertices", drive.error());
  auto writer = SequenceWriter::create(folder, header_of(*drive, arguments.seed));
  if (!writer) return fail(folder, writer.error());
  std::uint64_t changed = 0;
  std::uint64_t removed = 0;
  for (std::uint32_t i = 0; i < arguments.steps; ++i) {
    const SequenceStep step = drive->next();
    changed += step.changed.size();
    removed += step.removed.size();
    std::vector<SequenceBlock> blocks;
    for (const auto& [id, mesh] : drive->blocks()) blocks.push_back({id, mesh});
    if (auto added = writer->add(step, blocks); !added) return fail(folder, added.error());
  }
  std::cout << "rooms -> " << folder << ": " << counted(arguments.steps, "update", "updates") << ", "
            << counted(changed, "changed block", "changed blocks") << ", " << grouped(removed)
            << " removed; at the end " << counted(writer->vertices(), "vertex", "vertices") << ", "
            << counted(writer->triangles(), "triangle", "triangles") << '\n';
  return kOk;
}

int run_generate(const GenerateArguments& arguments) {
  if (!arguments.sequence.empty()) {
    if (scene_of_name(arguments.scene) == Scene::kRooms) return write_drive(arguments);
    print_error(arguments.scene, "only rooms are driven through");
    return kUsage;
  }
  if (arguments.out.empty()) {
    print_error("OUT", "is missing, or else --sequence");
    return kUsage;
  }
  int status = kOk;
  if (!check_mesh_suffix(arguments.out, status)) return status;
  const Result<Mesh> mesh = generate_showing_progress(arguments);
  if (!mesh) return fail(arguments.scene, mesh.error());
  WriteReport report;
  status = save_mesh(arguments.out, *mesh, {}, &report);
  if (status != kOk) return status;
  std::cout << arguments.scene << " -> " << arguments.out << ": "
            << counted(mesh->vertex_count(), "vertex", "vertices") << ", "
            << counted(mesh->triangle_count(), "triangle", "triangles") << '\n';
  print_left_out(report, std::cout);
  return status;
}

std::vector<std::string> known_scenes() {
  std::vector<std::string> names;
  for (const SceneName& scene : scene_names()) names.emplace_back(scene.name);
  return names;
}

std::string help_footer() {
  std::string text = "Scenes:\n";
  for (const SceneName& scene : scene_names()) {
    std::string name(scene.name);
    name.resize(11, ' ');
    text += "  " + name + std::string(scene.description) + '\n';
  }
  return text +
         "\nExamples:\n  deltamesh generate rooms map.ply --vertices 250000 --seed 7\n  deltamesh generate "
         "rooms --sequence "
         "drive --steps 50\n";
}

}  // namespace

void add_generate_command(CLI::App& app, int& status) {
  const auto arguments = std::make_shared<GenerateArguments>();
  CLI::App* command = app.add_subcommand("generate", "Make a test mesh; the same seed gives the same mesh");
  command->add_option("SCENE", arguments->scene, "what to make")
      ->required()
      ->check(CLI::IsMember(known_scenes()));
  command->add_option("OUT", arguments->out, std::string("mesh file to write: ") + kMeshSuffixes);
  command->add_option("--vertices", arguments->vertices, "how many, within about a tenth")
      ->capture_default_str();
  command->add_option("--seed", arguments->seed, "chooses among the meshes of a scene")
      ->check(refuse_negative)
      ->capture_default_str();
  command
      ->add_option("--sequence", arguments->sequence,
                   "folder to write: a robot's drive through the rooms, as blocks that change at 5 Hz")
      ->excludes("OUT");
  command->add_option("--steps", arguments->steps, "updates of the drive")
      ->capture_default_str()
      ->check(CLI::Range(1, 100000))
      ->needs("--sequence");
  command->footer(help_footer());
  command->callback([arguments, &status] { status = run_generate(*arguments); });
}

}  // namespace deltamesh::cli
