// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "colors/octree_levels.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

namespace deltamesh::bench {
namespace {

constexpr unsigned kCodeBits = 3 * kHaarPlaceBits;

/// Bit i of x, y and z at 3 i, 3 i + 1 and 3 i + 2.
std::uint64_t morton_code(const HaarPlace& place) {
  std::uint64_t code = 0;
  for (unsigned bit = 0; bit < kCodeBits; ++bit)
    code |= std::uint64_t{(static_cast<std::uint32_t>(place[bit % 3]) >> (bit / 3)) & 1} << bit;
  return code;
}

/// Pairs of nodes in one cell; empty where each cell has one.
LargeVector<std::uint32_t> mates_in_cells(const std::vector<std::uint64_t>& cells) {
  LargeVector<std::uint32_t> mates(cells.size());
  std::iota(mates.begin(), mates.end(), 0U);
  std::vector<std::uint32_t> order(mates.begin(), mates.end());
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return cells[a] < cells[b]; });
  bool any = false;
  for (std::size_t k = 0; k + 1 < order.size(); ++k) {
    if (cells[order[k]] != cells[order[k + 1]]) continue;
    mates[order[k]] = order[k + 1];
    mates[order[k + 1]] = order[k];
    any = true;
    ++k;
  }
  if (!any) mates.clear();
  return mates;
}

}  // namespace

std::vector<HaarLevel> make_octree_levels(const AttributeSurface& surface, OctreePrediction prediction) {
  std::vector<HaarLevel> levels;
  levels.push_back(first_haar_level(surface));
  if (prediction == OctreePrediction::kNone) {
    Adjacency& graph = levels.front().graph;
    std::fill(graph.offsets.begin(), graph.offsets.end(), 0U);
    graph.neighbors.clear();
  }
  std::vector<std::uint64_t> cells;
  for (const HaarNode& node : levels.front().nodes) cells.push_back(morton_code(node.place));
  for (unsigned bits = 0; bits <= kCodeBits; ++bits) {
    for (auto mates = mates_in_cells(cells); !mates.empty(); mates = mates_in_cells(cells)) {
      HaarLevel next = next_haar_level(levels.back(), mates);
      std::vector<std::uint64_t> joined;
      for (const HaarChildren& children : next.children) joined.push_back(cells[children.first]);
      cells.swap(joined);
      levels.push_back(std::move(next));
    }
    for (std::uint64_t& cell : cells) cell >>= 1;
  }
  return levels;
}

}  // namespace deltamesh::bench
