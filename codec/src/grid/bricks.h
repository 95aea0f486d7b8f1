// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The bricks of a grid that have known nodes, and the vertices on edges that begin at these.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "base/memory/large_vector.h"
#include "grid/brick.h"
#include "grid/cube/cube.h"

namespace deltamesh::grid {

/// A brick that knows the corners of a cube, and where they are there.
struct BrickCopy {
  std::uint8_t near;  ///< which one, seen from the cube's own brick
  std::int8_t shift;  ///< to the bit of the lowest corner, added to its x
  std::int16_t row;   ///< added to the row of the lowest corner
};
/// Bricks that know the corners of a cube: its own, and those that have one in their margin.
struct BrickCopies {
  unsigned count;
  std::array<BrickCopy, 8> list;
};

/// Of a cube's coordinates: 1 if its corners are in the margin of the brick on the low side, 2 on the high
/// side.
inline constexpr std::array<std::uint8_t, kSide> kBrickEnds = {1, 1, 0, 0, 0, 0, 0, 0,
                                                               0, 0, 0, 0, 0, 2, 2, 2};

/// By the ends on each axis.
inline constexpr std::array<BrickCopies, 27> kBrickCopies = [] {
  std::array<BrickCopies, 27> all{};
  for (int ends = 0; ends < 27; ++ends) {
    BrickCopies& copies = all[static_cast<std::size_t>(ends)];
    const int end[3] = {ends % 3, ends / 3 % 3, ends / 9};
    for (int way = 0; way < 27; ++way) {
      const int step[3] = {way % 3 - 1, way / 3 % 3 - 1, way / 9 - 1};
      bool has_them = true;
      for (int axis = 0; axis < 3; ++axis)
        has_them = has_them && (step[axis] == 0 || end[axis] == (step[axis] < 0 ? 1 : 2));
      if (!has_them) continue;
      copies.list[copies.count++] = {static_cast<std::uint8_t>(way),
                                     static_cast<std::int8_t>(kMargin - kSide * step[0]),
                                     static_cast<std::int16_t>(-kSide * (step[1] + kReach * step[2]))};
    }
  }
  return all;
}();

inline const BrickCopies& copies_of(unsigned place) noexcept {
  return kBrickCopies[kBrickEnds[place & 15] + 3U * kBrickEnds[place >> 4 & 15] +
                      9U * kBrickEnds[place >> 8]];
}

/// Storage that grows and whose elements keep their addresses.
template <class T>
class Pieces {
 public:
  /// One more element, uninitialised.
  T& take() {
    if (left_ == 0) {
      left_ = count_ < kFew ? std::max<std::size_t>(count_, 8) : kLargePage / sizeof(T);
      pieces_.emplace_back(left_);
    }
    ++count_;
    return pieces_.back()[pieces_.back().size() - left_--];
  }
  void free() noexcept { *this = {}; }

 private:
  static constexpr std::size_t kFew = 64;  ///< elements; pieces after these fill a large page each

  std::vector<LargeVector<T>> pieces_;
  std::size_t count_ = 0;  ///< that were taken
  std::size_t left_ = 0;   ///< in the last piece
};

class Bricks {
 public:
  using Place = std::array<std::int32_t, 3>;

  Bricks() = default;
  Bricks(Bricks&&) = default;
  Bricks& operator=(Bricks&&) = default;

  /// So that nothing moves while about so many vertices come.
  void reserve(std::size_t vertices) { vertices_.resize(vertices / 2 * kNodesOfTwo + 16 * kBlockNodes); }

  std::uint32_t count() const noexcept { return static_cast<std::uint32_t>(bricks_.size()); }
  Brick& operator[](std::uint32_t number) noexcept { return *bricks_[number]; }
  const Brick& operator[](std::uint32_t number) const noexcept { return *bricks_[number]; }

  Brick* find(const Place& at) const noexcept;
  /// The brick there, empty if it was not there.
  Brick& get(const Place& at);

  /// That at `way` from `brick`, an index of Brick::near.
  Brick& get_near(Brick& brick, unsigned way);
  /// The one that has the node at `spot` of `brick`, each coordinate -1 to 16, which becomes one of its own.
  Brick& home(Brick& brick, Spot& spot) {
    unsigned way = 13;
    for (std::size_t axis = 0, step = 1; axis < 3; ++axis, step *= 3) {
      way += (spot[axis] >> 4) * static_cast<int>(step);
      spot[axis] &= kSide - 1;
    }
    return brick.near[way] != nullptr ? *brick.near[way] : get_near(brick, way);
  }

  /// The brick that has this corner of a cube of `brick`, if it is known; `over`: see beyond().
  static Brick& brick_of(Brick& brick, unsigned over, unsigned corner) noexcept {
    static constexpr std::array<std::uint8_t, kCorners> kWays = {13, 14, 16, 17, 22, 23, 25, 26};
    return *brick.near[kWays[over & corner]];
  }

  /// Says which corners of the cube at `place` of `brick` are outside and which inside, of new ones and of
  /// such that are known. Bricks that have one are there afterwards.
  [[gnu::always_inline]] void set_corners(Brick& brick, unsigned place, Signs outside, Signs inside) {
    if (beyond(place) != 0) [[unlikely]]
      get_beyond(brick, place);
    const auto pair = [&](unsigned first) {
      return std::uint64_t{outside >> first & 3} | std::uint64_t{inside >> first & 3} << Brick::kInsideShift;
    };
    const std::uint64_t pairs[4] = {pair(0), pair(2), pair(4), pair(6)};
    const std::size_t row = Brick::row_at(place);
    // In margins of other bricks they are, too.
    const BrickCopies& copies = copies_of(place);
    for (unsigned i = 0; i < copies.count; ++i) {
      const BrickCopy& copy = copies.list[i];
      Brick* const other = brick.near[copy.near];
      if (other == nullptr) continue;
      std::uint64_t* const rows = &other->rows[row + static_cast<std::size_t>(std::ptrdiff_t{copy.row})];
      const int shift = static_cast<int>(place & 15) + copy.shift;
      rows[0] |= pairs[0] << shift;
      rows[1] |= pairs[1] << shift;
      rows[kReach] |= pairs[2] << shift;
      rows[kReach + 1] |= pairs[3] << shift;
    }
  }

  /// The vertex on the edge of `axis` that begins at the node `slot` [kSlots]; kNoVertex if there was none.
  [[gnu::always_inline]] std::uint32_t& vertex(Brick& brick, unsigned slot, unsigned axis) {
    std::uint32_t& block = brick.blocks[slot / kBlockNodes];
    if (block == 0) [[unlikely]]
      add_block(block);
    return vertices_[std::size_t{block} * kBlockNodes + slot % kBlockNodes][axis];
  }
  /// Precondition: there is one.
  [[gnu::always_inline]] std::uint32_t vertex(const Brick& brick, unsigned slot,
                                              unsigned axis) const noexcept {
    return vertices_[std::size_t{brick.blocks[slot / kBlockNodes]} * kBlockNodes + slot % kBlockNodes][axis];
  }

  /// Brick::cubes of all bricks: once no cube is coded any more.
  void free_cubes() noexcept;

  /// By place: lowest z first, then y, then x.
  std::vector<Brick*> in_order() const;

 private:
  static constexpr std::size_t kNodesOfTwo = 7;  ///< nodes of blocks for two vertices; seldom more

  void get_beyond(Brick& brick, unsigned place);
  void add_block(std::uint32_t& block);

  std::vector<Brick*> bricks_;
  std::map<Place, Brick*> by_place_;  ///< a tree, as a stream can have places of one hash
  Pieces<Brick> memory_;
  Pieces<std::array<std::uint8_t, kPlaces>> cubes_;
  LargeVector<std::array<std::uint32_t, 3>> vertices_;
  std::uint32_t block_count_ = 1;  ///< of those that are in use; number 0 is none
};

}  // namespace deltamesh::grid
