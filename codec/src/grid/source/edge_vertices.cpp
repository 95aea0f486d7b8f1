// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "grid/source/edge_vertices.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>

namespace deltamesh::grid {
namespace {

EdgeVertices::Home home_of(const Cell& cell, std::int32_t voxel) noexcept {
  EdgeVertices::Home home{.node = {}, .axis = EdgeVertices::Home::kCube};
  unsigned off = 0;
  bool is_level = false;
  std::uint8_t free_axis = 0;
  for (std::uint8_t axis = 0; axis < 3; ++axis) {
    home.node[axis] = cell[axis] / voxel;
    const std::int32_t rest = cell[axis] - home.node[axis] * voxel;
    if (rest == 0) continue;
    ++off;
    free_axis = axis;
    is_level = rest % 2 != 0;
  }
  if (off == 1 && is_level) home.axis = free_axis;
  return home;
}

std::uint64_t hash_of(const EdgeVertices::Home& home) noexcept {
  std::uint64_t hash = home.axis;
  for (const std::int32_t at : home.node) {
    hash = (hash ^ static_cast<std::uint32_t>(at)) * 0x9e3779b97f4a7c15ULL;
    hash ^= hash >> 32;
  }
  return hash * 0xd6e8feb86659fd93ULL;
}

}  // namespace

EdgeVertices::EdgeVertices(std::span<const Cell> cells, std::int32_t voxel) : homes_(cells.size()) {
  constexpr std::uint32_t kEmpty = 0xffffffff;
  // Open addressing, at most half full.
  const std::size_t slots = std::bit_ceil(2 * cells.size() + 2);
  const int shift = 64 - std::countr_zero(slots);
  std::vector<std::uint32_t> table(slots, kEmpty);
  for (std::uint32_t v = 0; v < cells.size(); ++v) {
    const Home home = home_of(cells[v], voxel);
    auto slot = static_cast<std::size_t>(hash_of(home) >> shift);
    while (table[slot] != kEmpty && homes_[table[slot]] != home) slot = (slot + 1) & (slots - 1);
    if (table[slot] != kEmpty) continue;
    table[slot] = v;
    homes_[v] = home;
  }
}

EdgeVertices::Cubes EdgeVertices::cubes_of(const std::array<std::uint32_t, 3>& face) const noexcept {
  Cubes cubes;
  if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) return cubes;
  Node low;
  Node high;
  low.fill(0);
  high.fill(std::numeric_limits<std::int32_t>::max());
  unsigned inside = 0;
  for (const std::uint32_t v : face) {
    const Home& home = homes_[v];
    if (home.axis == Home::kNowhere) return cubes;
    inside += home.axis == Home::kCube ? 1 : 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool is_shared = home.axis != Home::kCube && axis != home.axis;
      low[axis] = std::max(low[axis], home.node[axis] - (is_shared ? 1 : 0));
      high[axis] = std::min(high[axis], home.node[axis]);
    }
  }
  if (inside > 1) return cubes;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (low[axis] > high[axis]) return cubes;
  cubes.lowest[cubes.count++] = low;
  if (low != high) cubes.lowest[cubes.count++] = high;
  return cubes;
}

Triangle EdgeVertices::seen_from(const Node& lowest,
                                 const std::array<std::uint32_t, 3>& face) const noexcept {
  Triangle triangle{};
  for (std::size_t c = 0; c < 3; ++c) {
    const Home& home = homes_[face[c]];
    const unsigned k = home.axis;
    if (k == Home::kCube) {
      triangle[c] = kInside;
      continue;
    }
    const auto step = [&](unsigned axis) {
      return static_cast<unsigned>(home.node[axis % 3] - lowest[axis % 3]);
    };
    triangle[c] = static_cast<std::uint8_t>(4 * k + step(k + 1) + 2 * step(k + 2));
  }
  return triangle;
}

}  // namespace deltamesh::grid
