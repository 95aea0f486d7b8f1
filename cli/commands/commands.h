// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The subcommands. Each function adds one to the command line; when the user picks it, it runs while the line
// is parsed and leaves its exit code in `status`.
#pragma once

namespace CLI {
class App;
}

namespace deltamesh::cli {

void add_encode_command(CLI::App& app, int& status);
void add_decode_command(CLI::App& app, int& status);
void add_info_command(CLI::App& app, int& status);
void add_verify_command(CLI::App& app, int& status);
void add_compare_command(CLI::App& app, int& status);
void add_generate_command(CLI::App& app, int& status);
void add_gltf_command(CLI::App& app, int& status);
void add_map_command(CLI::App& app, int& status);
void add_tiles_command(CLI::App& app, int& status);

}  // namespace deltamesh::cli
