// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "commands/commands.h"
#include "deltamesh/decode.h"
#include "deltamesh/stream_info.h"
#include "map_files.h"
#include "mesh_files.h"
#include "report/console.h"
#include "report/progress.h"

namespace deltamesh::cli {
namespace {

Result<void> verify_showing_progress(std::span<const std::byte> bytes) {
  Progress progress("verifying");
  return verify(bytes, {.limits = {}, .progress = progress.callback()});
}

int run_verify(const std::string& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) return verify_map(file);
  const Result<std::vector<std::byte>> bytes = read_input(file);
  if (!bytes) return fail(file, bytes.error());
  const Result<StreamInfo> info = inspect(*bytes);
  if (!info) return fail(file, info.error());
  if (const Result<void> verified = verify_showing_progress(*bytes); !verified)
    return fail(file, verified.error());
  std::cout << file << ": ok, " << counted(info->vertices, "vertex", "vertices") << ", "
            << counted(info->triangles, "triangle", "triangles") << ", "
            << counted(info->chunks.size(), "chunk", "chunks") << '\n';
  return kOk;
}

}  // namespace

void add_verify_command(CLI::App& app, int& status) {
  const auto file = std::make_shared<std::string>();
  CLI::App* command =
      app.add_subcommand("verify", "Check a stream or a map: checksums, structure, and that it decodes");
  command->add_option("FILE", *file, "stream, .dmsh, or folder of a map; - is standard input")->required();
  command->footer(
      "Exit code 0 and `ok` where all is well, 1 and the first fault where not; of a map every "
      "part that is missing or damaged.\n");
  command->callback([file, &status] { status = run_verify(*file); });
}

}  // namespace deltamesh::cli
