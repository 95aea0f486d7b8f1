// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <optional>
#include <vector>

#include "deltamesh/map/tiles.h"
#include "stored/tile_plan.h"

namespace deltamesh::cli {

/// The parts of a tile, from the files that it needs. On failure prints why and leaves the exit code in
/// `status`.
std::optional<std::vector<TilePart>> load_tile(const FiledPlan& plan, std::size_t number, int& status);

/// Adds `tiles plan`, the largest of the commands on tiles.
void add_tiles_plan(CLI::App& tiles, int& status);

}  // namespace deltamesh::cli
