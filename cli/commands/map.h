// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#pragma once

#include <CLI/CLI.hpp>

namespace deltamesh::cli {

/// Adds `map split`, the largest of the commands on maps.
void add_map_split(CLI::App& map, int& status);

}  // namespace deltamesh::cli
