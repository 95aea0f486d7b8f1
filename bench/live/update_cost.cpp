// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "live/update_cost.h"

#include <algorithm>
#include <ctime>
#include <span>
#include <vector>

#include "deltamesh/map/sender.h"
#include "support/errors.h"

namespace deltamesh::bench {
namespace {

constexpr std::size_t kUpdates = 50;
constexpr double kMaxError = 0.05;  // voxels

double update_milliseconds(MapSender& sender, std::span<const MapBlock> blocks) {
  const std::clock_t begin = std::clock();
  check_or_exit(sender.update(blocks));
  return 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

}  // namespace

UpdateCost measure_update_cost(const MapUpdates& map, std::uint8_t copy_level) {
  MapSender sender = value_or_exit(
      MapSender::make(map_description(map, kMaxError * map.voxel), {.split = {.copy_level = copy_level}}));
  std::vector<MapBlock> blocks;
  for (const SequenceBlock& block : map.steps.front().changed) blocks.push_back({block.id, block.mesh});
  UpdateCost cost{.vertices = map.wholes.front().vertex_count(), .blocks = blocks.size()};
  cost.first = update_milliseconds(sender, blocks);
  cost.parts = sender.keys().size();
  std::vector<double> times;
  const std::size_t stride = std::max<std::size_t>(blocks.size() / kUpdates, 1);
  for (std::size_t i = 0; i < blocks.size(); i += stride) {
    Mesh moved = map.steps.front().changed[i].mesh;
    for (float& x : moved.positions) x += static_cast<float>(map.voxel / 4);
    const MapBlock block{blocks[i].cell, moved};
    times.push_back(update_milliseconds(sender, std::span(&block, 1)));
  }
  std::ranges::sort(times);
  cost.median = times[times.size() / 2];
  cost.largest = times.back();
  return cost;
}

}  // namespace deltamesh::bench
