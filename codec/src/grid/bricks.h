// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The bricks of a grid that have known nodes, and the vertices on edges that begin at these.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/memory/large_vector.h"
#include "grid/brick.h"

namespace deltamesh::grid {

class Bricks {
 public:
  using Place = std::array<std::int32_t, 3>;

  /// So that nothing moves while about so many vertices come.
  void reserve(std::size_t vertices) { vertices_.resize(kNodesOfVertex * vertices); }

  std::uint32_t count() const noexcept { return static_cast<std::uint32_t>(bricks_.size()); }
  Brick& operator[](std::uint32_t number) noexcept { return *bricks_[number]; }
  const Brick& operator[](std::uint32_t number) const noexcept { return *bricks_[number]; }

  Brick* find(const Place& at) const noexcept;
  /// The brick there, empty if it was not there.
  Brick& get(const Place& at);

  /// The one that has the node at `spot` of `brick`, each coordinate -1 to 16, which becomes one of its own.
  Brick& home(Brick& brick, Spot& spot) {
    unsigned way = 13;
    for (std::size_t axis = 0, step = 1; axis < 3; ++axis, step *= 3) {
      way += (spot[axis] >> 4) * static_cast<int>(step);
      spot[axis] &= kSide - 1;
    }
    return brick.near[way] != nullptr ? *brick.near[way] : get_near(brick, way);
  }

  /// Says where the node at `spot` of `brick` is, each coordinate 0 to 16.
  [[gnu::always_inline]] void set_node(Brick& brick, const Spot& spot, bool is_outside) {
    constexpr unsigned kInner = (1U << (kSide - kMargin)) - (1U << kMargin);
    const bool is_inner = (kInner >> spot[0] & kInner >> spot[1] & kInner >> spot[2] & 1) != 0;
    if (!is_inner) return set_outer_node(brick, spot, is_outside);
    brick.rows[Brick::row_at(spot[1], spot[2])] |= node_bit(spot[0], is_outside);
    give_rank(brick, place_of(spot));
  }

  /// The vertex on the edge of `axis` that begins at the known node `place`, or kNoVertex.
  [[gnu::always_inline]] std::uint32_t& vertex(const Brick& brick, unsigned place, unsigned axis) noexcept {
    const unsigned rank = brick.ranks[place];
    return vertices_[std::size_t{brick.groups[rank / kGroup]} + rank % kGroup][axis];
  }
  std::uint32_t vertex(const Brick& brick, unsigned place, unsigned axis) const noexcept {
    return const_cast<Bricks&>(*this).vertex(brick, place, axis);
  }

  /// By place: lowest z first, then y, then x.
  std::vector<Brick*> in_order() const;

 private:
  static constexpr std::size_t kNodesOfVertex = 3;  ///< at most, usually; with room in groups

  static std::uint64_t node_bit(int x, bool is_outside) noexcept {
    return (is_outside ? 1 : std::uint64_t{1} << Brick::kInsideShift) << (x + kMargin);
  }
  [[gnu::always_inline]] void give_rank(Brick& brick, unsigned place) {
    const unsigned rank = brick.known_nodes++;
    brick.ranks[place] = static_cast<std::uint16_t>(rank);
    if (rank % kGroup == 0) [[unlikely]]
      add_group(brick, rank);
  }

  Brick& get_near(Brick& brick, unsigned way);
  void set_outer_node(Brick& brick, Spot spot, bool is_outside);
  void add_group(Brick& brick, unsigned rank);
  void make_room();
  std::size_t slot_of(const Place& at) const noexcept;

  std::vector<Brick*> bricks_;
  std::vector<std::uint32_t> table_;  ///< by hash of the place: number of a brick plus 1, or 0
  std::vector<LargeVector<Brick>> memory_;
  std::size_t left_ = 0;  ///< bricks in the last piece of it
  LargeVector<std::array<std::uint32_t, 3>> vertices_;
  std::uint32_t vertex_end_ = 0;  ///< of those that are in use
};

}  // namespace deltamesh::grid
