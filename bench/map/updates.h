// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Sequences of a map's updates, block by block: folders of updates, and whole maps cut into blocks.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "deltamesh/map/description.h"
#include "deltamesh/mesh.h"
#include "deltamesh/result.h"
#include "sequence.h"

namespace deltamesh::bench {

struct MapUpdates {
  std::string name;
  double voxel = 0;
  double block_metres = 0;
  std::array<double, 3> origin{};
  std::vector<SequenceStep> steps;
  std::vector<Mesh> wholes;  ///< after each step
};

/// A folder with sequence.json.
Result<MapUpdates> read_updates(const std::string& folder, const std::string& name);

/// A folder of whole maps step_00.ply, step_01.ply and so on: blocks of `block_voxels` voxels, counted from
/// `origin`, that are not as in the step before.
Result<MapUpdates> cut_wholes(const std::string& folder, const std::string& name, double voxel,
                              int block_voxels, const std::array<double, 3>& origin = {});

/// One update: all blocks of generated rooms.
Result<MapUpdates> rooms_at_once(std::uint64_t vertices);

/// A generated drive.
Result<MapUpdates> drive_updates(std::uint64_t vertices, std::uint32_t steps);

/// For updates with this largest error, model units; without primers.
MapDescription map_description(const MapUpdates& updates, double max_error);

}  // namespace deltamesh::bench
