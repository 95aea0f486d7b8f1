// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Numbers around a vertex that its own may well be equal to, as on flat and swept surfaces [FLT-4, POSN-9].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "base/simd/four_ints.h"
#include "positions/blend/blend.h"
#include "positions/surroundings.h"

namespace deltamesh {

/// Different numbers on every axis, nearest to the expected one first. All axes at once and without branches,
/// as what is equal and what is nearer cannot be foretold.
class Guesses {
 public:
  static constexpr unsigned kMost = 6;
  static constexpr std::size_t kMostAdded = std::size_t{3} * Surroundings::kMostKnown;

  explicit Guesses(FourInts expected) noexcept : expected_(expected) {}

  /// Up to kMostAdded times. Of equally near ones the first goes first; the seventh and later are dropped.
  /// `allowed`: -1 on axes where there is a number, else 0.
  [[gnu::always_inline]] void add(FourInts numbers, FourInts allowed) noexcept {
    FourInts is_new = allowed & (count_ < static_cast<std::int32_t>(kMost));
    for (std::size_t i = 0; i < added_; ++i) is_new &= numbers != entries_[i].numbers;
    const FourInts off = off_of(numbers);
    FourInts place = count_;
    for (std::size_t i = 0; i < added_; ++i) {
      Entry& entry = entries_[i];
      const FourInts is_nearer = off < entry.off;
      place += is_nearer;
      entry.place -= is_nearer & is_new;
    }
    entries_[added_++] = {numbers, (off & is_new) | (~is_new & kNearest), place | ~is_new};
    count_ -= is_new;
  }

  unsigned count(std::size_t axis) const noexcept {
    return static_cast<unsigned>(count_[static_cast<int>(axis)]);
  }
  /// `place`: below count().
  std::int32_t at(std::size_t axis, unsigned place) const noexcept {
    FourInts found{};
    for (std::size_t i = 0; i < added_; ++i)
      found |= entries_[i].numbers & (entries_[i].place == static_cast<std::int32_t>(place));
    return found[static_cast<int>(axis)];
  }
  /// One more than the place of `number`, or 0.
  unsigned symbol_of(std::size_t axis, std::int32_t number) const noexcept {
    const int lane = static_cast<int>(axis);
    for (std::size_t i = 0; i < added_; ++i)
      if (entries_[i].numbers[lane] == number && entries_[i].place[lane] >= 0)
        return static_cast<unsigned>(entries_[i].place[lane]) + 1;
    return 0;
  }

 private:
  static constexpr std::int32_t kNearest = std::numeric_limits<std::int32_t>::min();

  struct Entry {
    FourInts numbers;
    FourInts off;    ///< from the expected ones, kNearest being 0; kNearest where the number is not listed
    FourInts place;  ///< -1 where it is not
  };

  FourInts off_of(FourInts numbers) const noexcept {
    const auto is_below = reinterpret_cast<FourUnsigned>(numbers < expected_);
    const FourUnsigned difference =
        reinterpret_cast<FourUnsigned>(numbers) - reinterpret_cast<FourUnsigned>(expected_);
    return reinterpret_cast<FourInts>(((difference ^ is_below) - is_below) ^
                                      static_cast<std::uint32_t>(kNearest));
  }

  FourInts expected_;
  FourInts count_{};
  std::size_t added_ = 0;
  std::array<Entry, kMostAdded> entries_;
};

/// The corners of the parallelograms, as far as they are 0 to `most`, then those of the known faces [POSN-9].
inline Guesses guesses_around(const Surroundings& around, std::span<const Cell> cells, FourInts expected,
                              FourInts most) noexcept {
  Guesses guesses(expected);
  for (unsigned i = 0; i < around.known_count; ++i) {
    const auto& [a, b, opposite] = around.known[i];
    if (opposite == kNoVertex) continue;
    const FourInts corner = four_ints(cells[a]) + four_ints(cells[b]) - four_ints(cells[opposite]);
    guesses.add(corner, (corner >= 0) & (corner <= most));
  }
  const FourInts always = ~FourInts{};
  for (unsigned i = 0; i < around.known_count; ++i) {
    guesses.add(four_ints(cells[around.known[i].a]), always);
    guesses.add(four_ints(cells[around.known[i].b]), always);
  }
  return guesses;
}

}  // namespace deltamesh
