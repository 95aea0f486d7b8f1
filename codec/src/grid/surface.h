// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A surface as it grows: nodes that are known, faces, and the vertices that these brought in [GRD-8].
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
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
  std::uint32_t most_bricks = 0;                 ///< with known nodes; at most kMostBricks
};
/// A brick's number and a place in it are 32 bits; a few more bricks than allowed come before it is noticed.
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

/// Faces of vertices, added cube by cube.
class Triangles {
 public:
  /// So that nothing moves while about so many come.
  void reserve(std::size_t count) { list_.resize(count + Pattern::kMostTriangles); }
  /// For those of one more cube.
  [[gnu::always_inline]] void make_room() {
    if (list_.size() - count_ < Pattern::kMostTriangles) [[unlikely]]
      list_.resize(2 * list_.size() + 1024);
  }
  /// Precondition: there is room.
  void add(const std::array<std::uint32_t, 3>& triangle) noexcept { list_[count_++] = triangle; }

  std::size_t size() const noexcept { return count_; }
  const std::array<std::uint32_t, 3>& operator[](std::size_t i) const noexcept { return list_[i]; }
  LargeVector<std::array<std::uint32_t, 3>> take() {
    list_.resize(count_);
    return std::move(list_);
  }

 private:
  LargeVector<std::array<std::uint32_t, 3>> list_;
  std::size_t count_ = 0;
};

struct Surface {
  Bricks bricks;
  Triangles triangles;
  std::uint32_t vertex_count = 0;
  std::vector<InnerVertex> inner;
  std::vector<std::uint32_t> cubes;  ///< a writer's: those of its source, in the order of `triangles`

  /// The faces of the cube at `place` of `brick`, all of whose corners are known.
  [[gnu::always_inline]] void add_faces(Brick& brick, unsigned place, const Pattern& pattern) {
    std::array<std::uint32_t, kEdges + 1> vertices;
    unsigned used = pattern.used() & ((1U << kEdges) - 1);
    if (!reaches_beyond(place)) [[likely]] {
      for (; used != 0; used &= used - 1) {
        const auto edge = static_cast<unsigned>(std::countr_zero(used));
        vertices[edge] = vertex_on(brick, place + kCornerSteps[first_corner(edge)], edge / 4);
      }
    } else {
      for (; used != 0; used &= used - 1) {
        const auto edge = static_cast<unsigned>(std::countr_zero(used));
        Spot node = corner_at(spot_of(place), first_corner(edge));
        Brick& own = bricks.home(brick, node);
        vertices[edge] = vertex_on(own, place_of(node), edge / 4);
      }
    }
    if (pattern.has_inner()) [[unlikely]]
      vertices[kInside] = vertex_count++;
    triangles.make_room();
    for (const Triangle& triangle : pattern.triangles())
      triangles.add({vertices[triangle[0]], vertices[triangle[1]], vertices[triangle[2]]});
  }

  static Spot corner_at(const Spot& spot, unsigned corner) noexcept {
    return {spot[0] + static_cast<int>(corner & 1), spot[1] + static_cast<int>(corner >> 1 & 1),
            spot[2] + static_cast<int>(corner >> 2)};
  }
  /// Whether some corner of the cube is not in its brick.
  static bool reaches_beyond(unsigned place) noexcept {
    // A digit of 15 carries into the bit above it.
    const unsigned digits = (place & 0xf) | (place & 0xf0) << 1 | (place & 0xf00) << 2;
    return ((digits + 0x421) & 0x4210) != 0;
  }

 private:
  /// The vertex on the edge of `axis` that begins at this node, which is a new one if there was none.
  [[gnu::always_inline]] std::uint32_t vertex_on(Brick& brick, unsigned node, unsigned axis) noexcept {
    std::uint32_t& vertex = bricks.vertex(brick, node, axis);
    // Without a branch, which would go wrong every other time.
    const bool is_new = vertex == kNoVertex;
    const std::uint32_t result = is_new ? vertex_count : vertex;
    vertex = result;
    vertex_count += is_new ? 1 : 0;
    std::uint16_t& row = brick.cut[axis][node >> 4];
    row = static_cast<std::uint16_t>(row | 1U << (node & 15));
    return result;
  }
};

}  // namespace deltamesh::grid
