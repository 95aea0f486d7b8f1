// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A surface as it grows: nodes that are known, faces, and the vertices that these brought in [GRD-8].
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/memory/large_vector.h"
#include "grid/bricks.h"
#include "grid/cube/cube.h"
#include "grid/cube/pattern.h"

namespace deltamesh::grid {

/// What a surface is bounded by.
struct Limits {
  std::uint32_t vertices = 0;
  std::uint32_t triangles = 0;
  std::uint32_t voxel = 2;                       ///< steps of the lattice
  std::array<std::uint32_t, 3> bricks{1, 1, 1};  ///< that seeds may be in, by axis; fewer than 2^32 in all
  std::uint32_t most_bricks = 0;                 ///< with known nodes; below kMostBricks
};
/// A brick's number and a place in it are 32 bits; some more bricks than allowed come before it is noticed.
inline constexpr std::uint32_t kMostBricks = (1U << 20) - 64;

/// A cube, by its lowest node.
struct CubePlace {
  Bricks::Place brick{};
  std::uint32_t place = 0;
};

struct InnerVertex {
  std::uint32_t vertex = 0;
  Bricks::Place brick{};
  Spot spot{};
  std::array<std::uint32_t, 3> offset{};  ///< from the lowest node of its cube, steps
};

struct Surface {
  Bricks bricks;
  LargeVector<std::array<std::uint32_t, 3>> triangles;
  std::uint32_t vertex_count = 0;
  std::vector<InnerVertex> inner;
  std::vector<std::uint32_t> cubes;  ///< a writer's: those of its source, in the order of `triangles`

  /// The vertex on the edge of `axis` that begins at this node, which is a new one if there was none.
  [[gnu::always_inline]] std::uint32_t vertex_on(Brick& brick, const Spot& node, unsigned axis) noexcept {
    std::uint32_t& vertex = bricks.vertex(brick, place_of(node), axis);
    // Without a branch, which would go wrong every other time.
    const bool is_new = vertex == kNoVertex;
    const std::uint32_t result = is_new ? vertex_count : vertex;
    vertex = result;
    vertex_count += is_new ? 1 : 0;
    std::uint16_t& row = brick.cut[axis][static_cast<std::size_t>(node[1] + kSide * node[2])];
    row = static_cast<std::uint16_t>(row | 1U << node[0]);
    return result;
  }

  /// The faces of the cube at `spot` of `brick`, all of whose corners are known.
  [[gnu::always_inline]] void add_faces(Brick& brick, const Spot& spot, const Pattern& pattern) {
    std::array<std::uint32_t, kEdges + 1> vertices;
    const bool is_inner = spot[0] < kSide - 1 && spot[1] < kSide - 1 && spot[2] < kSide - 1;
    for (unsigned used = pattern.used() & ((1U << kEdges) - 1); used != 0; used &= used - 1) {
      const auto edge = static_cast<unsigned>(std::countr_zero(used));
      Spot node = corner_at(spot, first_corner(edge));
      Brick& own = is_inner ? brick : bricks.home(brick, node);
      vertices[edge] = vertex_on(own, node, edge / 4);
    }
    if (pattern.has_inner()) [[unlikely]]
      vertices[kInside] = vertex_count++;
    for (const Triangle& triangle : pattern.triangles())
      triangles.push_back({vertices[triangle[0]], vertices[triangle[1]], vertices[triangle[2]]});
  }

  static Spot corner_at(const Spot& spot, unsigned corner) noexcept {
    return {spot[0] + static_cast<int>(corner & 1), spot[1] + static_cast<int>(corner >> 1 & 1),
            spot[2] + static_cast<int>(corner >> 2)};
  }
};

}  // namespace deltamesh::grid
