// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

#include "commands/commands.h"
#include "map_files.h"
#include "mesh_files.h"
#include "report/console.h"
#include "report/losses.h"

namespace deltamesh::cli {
namespace {

struct DecodeArguments {
  std::string in;
  std::string out;
  unsigned threads = 1;
  bool json = false;
  FileOptions files;
};

int run_decode(const DecodeArguments& arguments) {
  int status = kOk;
  if (refuse_map(arguments.in, "map join")) return kBadInput;
  if (!check_mesh_suffix(arguments.out, status, arguments.files) ||
      !check_keeps_input(arguments.in, arguments.out, status))
    return status;
  const std::optional<LoadedStream> stream = load_stream(arguments.in, status, arguments.threads);
  if (!stream) return status;
  const Mesh& mesh = stream->mesh;
  WriteReport report;
  status = save_mesh(arguments.out, mesh, arguments.files, &report, stream->keeps_order);
  if (status != kOk) return status;
  std::ostream& out = report_stream(arguments.out);
  if (arguments.json) {
    print_json({{"vertices", mesh.vertex_count()},
                {"triangles", mesh.triangle_count()},
                {"left_out", left_out_array(report)}},
               out);
    return status;
  }
  out << arguments.in << " -> " << arguments.out << ": " << counted(mesh.vertex_count(), "vertex", "vertices")
      << ", " << counted(mesh.triangle_count(), "triangle", "triangles") << '\n';
  print_left_out(report, out);
  return status;
}

}  // namespace

void add_decode_command(CLI::App& app, int& status) {
  const auto arguments = std::make_shared<DecodeArguments>();
  CLI::App* command = app.add_subcommand("decode", "Turn a .dmsh stream back into a mesh file");
  command->add_option("IN", arguments->in, "stream, .dmsh; - is standard input")->required();
  command
      ->add_option("OUT", arguments->out,
                   std::string("mesh file to write: ") + kMeshSuffixes + "; - is standard output")
      ->required();
  add_file_options(*command, arguments->files, false);
  command->add_flag("--json", arguments->json, "print one JSON object to standard output");
  command
      ->add_option("--threads", arguments->threads,
                   "threads to decode on; 0: as many as the machine runs at once; the mesh is the same")
      ->check(CLI::Range(0U, 256U))
      ->capture_default_str();
  command->footer(
      "Examples:\n"
      "  deltamesh decode bunny.dmsh bunny.ply\n"
      "  deltamesh decode bunny.dmsh bunny.glb\n");
  command->callback([arguments, &status] { status = run_decode(*arguments); });
}

}  // namespace deltamesh::cli
