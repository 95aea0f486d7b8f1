// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "commands/commands.h"
#include "mesh_files.h"
#include "report/console.h"

namespace deltamesh::cli {
namespace {

struct DecodeArguments {
  std::string in;
  std::string out;
  unsigned threads = 1;
};

int run_decode(const DecodeArguments& arguments) {
  int status = kOk;
  if (!check_mesh_suffix(arguments.out, status)) return status;
  const std::optional<Mesh> mesh = load_stream(arguments.in, status, arguments.threads);
  if (!mesh) return status;
  status = save_mesh(arguments.out, *mesh);
  if (status == kOk)
    std::cout << arguments.in << " -> " << arguments.out << ": "
              << counted(mesh->vertex_count(), "vertex", "vertices") << ", "
              << counted(mesh->triangle_count(), "triangle", "triangles") << '\n';
  return status;
}

}  // namespace

void add_decode_command(CLI::App& app, int& status) {
  const auto arguments = std::make_shared<DecodeArguments>();
  CLI::App* command = app.add_subcommand("decode", "Turn a .dmsh stream back into a mesh file");
  command->add_option("IN", arguments->in, "stream, .dmsh")->required();
  command->add_option("OUT", arguments->out, std::string("mesh file to write: ") + kMeshSuffixes)->required();
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
