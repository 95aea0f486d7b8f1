// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A plan of tiles in the folder of the map that they are to make: tiles/plan.json, and beside it the map's
// message and a manifest for each tile that is done.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "deltamesh/map/tiles.h"

namespace deltamesh::cli {

struct FiledPlan {
  TilePlan plan;
  std::vector<std::string> files;           ///< of the meshes, by number
  bool drop_invalid = false;                ///< as ReadOptions, for all of them
  std::optional<AttributeQuality> asked{};  ///< of attributes; empty: nothing
};

/// Replaces the plan that a folder has, and forgets which tiles were done. Errors: kFileWrite, kOutOfMemory.
Result<void> save_plan(const std::string& folder, const FiledPlan& plan);

bool has_plan(const std::string& folder);

/// Empty, and what is wrong of which file, where the folder has no plan or one that is damaged.
std::optional<FiledPlan> load_plan(const std::string& folder, std::string& wrong);

/// The file that is there once a tile is done: its manifest.
std::string tile_file(const std::string& folder, std::size_t tile);

/// Deletes what encoders that were killed left beside tile files.
void delete_unfinished(const std::string& folder);

}  // namespace deltamesh::cli
