// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A surface as it grows: nodes that are known, faces, and the vertices that these brought in [GRD-8].
#pragma once

#include <algorithm>
#include <array>
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
  /// Those of one more cube. `vertices`: on its edges and inside.
  [[gnu::always_inline]] void add(const Pattern& pattern,
                                  const std::array<std::uint32_t, kEdges + 4>& vertices) {
    if (list_.size() - count_ < Pattern::kMostTriangles) [[unlikely]]
      list_.resize(2 * list_.size() + 1024);
    const Triangle* const triangles = pattern.triangles().data();
    const auto add = [&](std::size_t i) {
      const Triangle& triangle = triangles[i];
      list_[count_ + i] = {vertices[triangle[0]], vertices[triangle[1]], vertices[triangle[2]]};
    };
    // Most have up to four, and others are overwritten.
    for (std::size_t i = 0; i < 4; ++i) add(i);
    const std::size_t count = pattern.triangles().size();
    for (std::size_t i = 4; i < count; ++i) add(i);
    count_ += count;
  }

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
  [[gnu::always_inline]] void add_faces(Brick& brick, unsigned place, const ListedPattern& pattern) {
    std::array<std::uint32_t, kEdges + 4> vertices{};
    const unsigned over = beyond(place);
    const std::array<std::uint16_t, kCorners> slots = corner_slots(place);
    const auto add_edge = [&](unsigned i) {
      const unsigned edge = pattern.edges[i];
      const unsigned corner = first_corner(edge);
      Brick& own = Bricks::brick_of(brick, over, corner);
      const unsigned node = place + kCornerSteps[corner] - kSide * kCornerSteps[over & corner];
      own.cut[node >> 4] |= Brick::cut_bit(node & 15, edge / 4);
      vertices[edge] = add_vertex(bricks.vertex(own, slots[corner], edge / 4));
    };
    // Loops of another number of turns each time would go wrong often.
    for (unsigned i = 0; i < ListedPattern::kUsual; ++i) add_edge(i);
    for (unsigned i = ListedPattern::kUsual; i < pattern.edge_count; ++i) add_edge(i);
    if (pattern.pattern.has_inner()) [[unlikely]]
      vertices[kInside] = vertex_count++;
    triangles.add(pattern.pattern, vertices);
  }

 private:
  [[gnu::always_inline]] static std::array<std::uint16_t, kCorners> corner_slots(unsigned place) noexcept {
    const std::uint16_t* const x = &kSlots[0][place & 15];
    const std::uint16_t* const y = &kSlots[1][place >> 4 & 15];
    const std::uint16_t* const z = &kSlots[2][place >> 8];
    std::array<std::uint16_t, kCorners> slots;
    for (unsigned i = 0; i < kCorners; ++i)
      slots[i] = static_cast<std::uint16_t>(x[i & 1] + y[i >> 1 & 1] + z[i >> 2]);
    return slots;
  }

  /// A new one if `vertex` is none.
  [[gnu::always_inline]] std::uint32_t add_vertex(std::uint32_t& vertex) noexcept {
    // Without a branch, which would go wrong every other time.
    static_assert(kNoVertex == 0xffffffff);
    vertex = std::min(vertex, vertex_count);
    vertex_count += vertex == vertex_count ? 1 : 0;
    return vertex;
  }
};

}  // namespace deltamesh::grid
