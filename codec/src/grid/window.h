// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The 4 x 4 x 4 nodes around a cube, and the contexts that they are [GRD-3, GRD-4].
#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#include "grid/brick.h"
#include "grid/cube/cube.h"

namespace deltamesh::grid {

/// What is known of a cube's corners.
struct Corners {
  /// Of the cube at `place` of `brick`.
  [[gnu::always_inline]] Corners(const Brick& brick, unsigned place) noexcept {
    const std::uint64_t* const rows = brick.rows.data() + Brick::row_at(place);
    const unsigned shift = (place & 15) + kMargin;
    constexpr std::uint64_t kTwo = 0x3'0000'0003;
    const std::uint64_t low = (rows[0] >> shift & kTwo) | (rows[1] >> shift & kTwo) << 2;
    const std::uint64_t high = (rows[kReach] >> shift & kTwo) | (rows[kReach + 1] >> shift & kTwo) << 2;
    const std::uint64_t both = low | high << 4;
    outside = static_cast<Signs>(both & 0xff);
    inside = static_cast<Signs>(both >> Brick::kInsideShift);
  }
  unsigned known() const noexcept { return outside | inside; }

  Signs outside;
  Signs inside;
};

/// A bit for every node: x + 4 y + 16 z, from the one that is one below the cube's lowest on each axis.
class Window {
 public:
  /// Around the cube at `place` of `brick`.
  [[gnu::always_inline]] Window(const Brick& brick, unsigned place) noexcept {
    const std::uint64_t* const first = brick.rows.data() + Brick::row_at(place) - kReach - 1;
    const int shift = static_cast<int>(place & 15) + kMargin - 1;
    const TwoLongs low = plane(first, shift) | plane(first + kReach, shift) << 16;
    const TwoLongs high = plane(first + 2 * kReach, shift) | plane(first + 3 * kReach, shift) << 16;
    const std::uint64_t lower = low[0] | low[1] << 4;
    const std::uint64_t upper = high[0] | high[1] << 4;
    constexpr std::uint64_t kHalf = 0xffff'ffff;
    outside_ = (lower & kHalf) | upper << 32;
    inside_ = lower >> 32 | (upper & ~kHalf);
  }

  /// Of the 19 nodes that are next to the corner, or across a square or a cube from it, and not the cube's:
  /// 0 if more are inside than outside, 1 if as many, else 2.
  [[gnu::always_inline]] unsigned majority(unsigned corner) const noexcept {
    const std::uint64_t around = kAround[corner];
    // The difference of two sums of 16 digits of 4 bits, which are 4 at most.
    constexpr std::uint64_t kFours = 0x4444'4444'4444'4444;
    const std::uint64_t more = fours(outside_ & around) + kFours - fours(inside_ & around);
    constexpr std::uint64_t kBytes = 0x0f0f'0f0f'0f0f'0f0f;
    const auto sum =
        static_cast<unsigned>(((more & kBytes) + (more >> 4 & kBytes)) * 0x0101'0101'0101'0101 >> 56);
    return (sum >> 6) + ((sum + 63) >> 7);  // 64 if as many
  }

 private:
  using TwoLongs = std::uint64_t __attribute__((vector_size(16)));

  /// Four rows, of which the first and the second are in different lanes, eight bits from the next two.
  [[gnu::always_inline]] static TwoLongs plane(const std::uint64_t* rows, int shift) noexcept {
    constexpr TwoLongs kFour = {0xf'0000'000f, 0xf'0000'000f};
    TwoLongs first;
    TwoLongs next;
    std::memcpy(&first, rows, sizeof(first));
    std::memcpy(&next, rows + 2, sizeof(next));
    return (first >> shift & kFour) | (next >> shift & kFour) << 8;
  }

  /// How many bits are set, in each four. Processors may have no instruction that counts them.
  static std::uint64_t fours(std::uint64_t bits) noexcept {
    bits -= bits >> 1 & 0x5555'5555'5555'5555;
    return (bits & 0x3333'3333'3333'3333) + (bits >> 2 & 0x3333'3333'3333'3333);
  }

  static constexpr std::array<std::uint8_t, kCorners> kCornerBit = {21, 22, 25, 26, 37, 38, 41, 42};
  static constexpr std::array<std::uint64_t, kCorners> kAround = [] {
    std::array<std::uint64_t, kCorners> around{};
    for (unsigned corner = 0; corner < kCorners; ++corner) {
      for (unsigned i = 0; i < 27; ++i)
        around[corner] |= std::uint64_t{1}
                          << (kCornerBit[corner] - 21 + i % 3 + 4 * (i / 3 % 3) + 16 * (i / 9));
      for (const unsigned own : kCornerBit) around[corner] &= ~(std::uint64_t{1} << own);
    }
    return around;
  }();

  std::uint64_t outside_ = 0;
  std::uint64_t inside_ = 0;
};

/// For a corner and a set of corners: the sum of 3^(t - 1) over those at t, exclusive or, from the corner.
inline constexpr std::array<std::array<std::uint16_t, 256>, kCorners> kThirds = [] {
  std::array<std::array<std::uint16_t, 256>, kCorners> thirds{};
  for (unsigned corner = 0; corner < kCorners; ++corner) {
    for (unsigned set = 0; set < 256; ++set) {
      unsigned sum = 0;
      for (unsigned t = kCorners - 1; t > 0; --t) sum = 3 * sum + (set >> (corner ^ t) & 1);
      thirds[corner][set] = static_cast<std::uint16_t>(sum);
    }
  }
  return thirds;
}();

}  // namespace deltamesh::grid
