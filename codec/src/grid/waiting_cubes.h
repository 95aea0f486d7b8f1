// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Cubes at the border of what has grown, and what they know of cubes without faces [GRD-3, GRD-7].
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/memory/large_vector.h"
#include "grid/bricks.h"
#include "grid/cube/cube.h"

namespace deltamesh::grid {

/// First in, first out.
class WaitingCubes {
 public:
  /// `bricks` must outlive it.
  explicit WaitingCubes(Bricks& bricks) noexcept : bricks_(bricks) {}

  bool empty() const noexcept { return next_ == end_; }

  struct Cube {
    Brick* brick;
    unsigned place;
  };
  /// Precondition: not empty.
  [[gnu::always_inline]] Cube take() noexcept {
    prefetch(cubes_[std::min(next_ + kAhead, end_ - 1)]);
    const CubeId cube = cubes_[next_++];
    return {&bricks_[cube >> kPlaceBits], static_cast<unsigned>(cube % kPlaces)};
  }

  /// If it did not wait before.
  void add(Brick& brick, unsigned place) {
    make_room();
    add_waiting(brick, place);
  }

  /// Those across faces of the cube at `place` of `brick`, if they did not wait before. `faces`: a bit for
  /// each.
  [[gnu::always_inline]] void add_across(Brick& brick, unsigned place, unsigned faces) {
    make_room();
    for (; faces != 0; faces &= faces - 1)
      wait_for(brick, place, static_cast<unsigned>(std::countr_zero(faces)));
  }

  /// The cube there has no faces: tells those around [GRD-3].
  [[gnu::noinline]] void count_faceless(Brick& brick, unsigned place) {
    const Spot spot = spot_of(place);
    const bool is_inner = static_cast<unsigned>(spot[0] - 1) < kSide - 2 &&
                          static_cast<unsigned>(spot[1] - 1) < kSide - 2 &&
                          static_cast<unsigned>(spot[2] - 1) < kSide - 2;
    for (std::size_t i = 0; i < kSharing.size(); ++i) {
      const Spot& step = kSharing[i];
      std::uint8_t* cube = nullptr;
      if (is_inner) [[likely]] {
        cube = &brick.cubes[place + static_cast<unsigned>(step[0] + kSide * (step[1] + kSide * step[2]))];
      } else {
        Spot other = {spot[0] + step[0], spot[1] + step[1], spot[2] + step[2]};
        Brick& own = bricks_.home(brick, other);
        cube = &own.cubes[place_of(other)];
      }
      const bool is_full = i >= kFaces && *cube % 8 == 7;
      *cube = static_cast<std::uint8_t>(*cube + (i < kFaces ? 8 : is_full ? 0 : 1));
    }
  }

 private:
  [[gnu::always_inline]] void make_room() {
    if (cubes_.size() - end_ < kFaces) [[unlikely]]
      move_to_front();
  }
  /// Moves waiting cubes to the front; doubles the array if they fill more than half of it.
  [[gnu::noinline]] void move_to_front() {
    std::copy(cubes_.begin() + static_cast<std::ptrdiff_t>(next_),
              cubes_.begin() + static_cast<std::ptrdiff_t>(end_), cubes_.begin());
    end_ -= std::exchange(next_, 0);
    cubes_.resize(std::max(cubes_.size(), 2 * end_ + 256));
  }

  /// Number of a brick and place there.
  using CubeId = std::uint32_t;
  static constexpr unsigned kPlaceBits = 12;
  static constexpr std::size_t kAhead = 6;  ///< so many cubes before its turn memory is fetched

  [[gnu::always_inline]] void prefetch(CubeId cube) const noexcept {
    const Brick& brick = bricks_[cube >> kPlaceBits];
    const std::uint64_t* const rows = brick.rows.data() + Brick::row_at(cube % kPlaces);
    for (int z = -1; z < 3; ++z) __builtin_prefetch(rows + kReach * z);
    __builtin_prefetch(&brick.cubes[cube % kPlaces]);
  }

  [[gnu::always_inline]] void wait_for(Brick& brick, unsigned place, unsigned face) {
    struct Way {
      std::uint16_t digit;  ///< of the place, and what it is at the end of the brick
      std::uint16_t end;
      std::int16_t step;
      std::uint16_t near;  ///< brick after that
    };
    static constexpr std::array<Way, kFaces> kWays = {{{0xf, 0, -1, 12},
                                                       {0xf, 0xf, 1, 14},
                                                       {0xf0, 0, -16, 10},
                                                       {0xf0, 0xf0, 16, 16},
                                                       {0xf00, 0, -256, 4},
                                                       {0xf00, 0xf00, 256, 22}}};
    const Way& way = kWays[face];
    const unsigned near = (place & way.digit) == way.end ? way.near : 13;
    Brick* const other = brick.near[near];
    const unsigned digit = (place + static_cast<unsigned>(way.step)) & way.digit;
    const unsigned next = (place & ~unsigned{way.digit}) | digit;
    add_waiting(other != nullptr ? *other : bricks_.get_near(brick, near), next);
  }
  /// There is room for one more, which is written even if it is there already.
  [[gnu::always_inline]] void add_waiting(Brick& brick, unsigned place) noexcept {
    std::uint8_t& cube = brick.cubes[place];
    cubes_[end_] = brick.number << kPlaceBits | place;
    end_ += (cube & Brick::kSeen) == 0 ? 1 : 0;
    cube |= Brick::kSeen;
  }

  /// To cubes that share a face with one, then to those that share an edge.
  static constexpr std::array<Spot, kFaces + kEdges> kSharing = [] {
    std::array<Spot, kFaces + kEdges> steps{};
    std::size_t next_face = 0;
    std::size_t next_edge = kFaces;
    for (int i = 0; i < 27; ++i) {
      const Spot step = {i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
      const int apart = step[0] * step[0] + step[1] * step[1] + step[2] * step[2];
      if (apart == 1) steps[next_face++] = step;
      if (apart == 2) steps[next_edge++] = step;
    }
    return steps;
  }();

  Bricks& bricks_;
  LargeVector<CubeId> cubes_;
  std::size_t next_ = 0;
  std::size_t end_ = 0;
};

}  // namespace deltamesh::grid
