// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which joints a vertex may have, from those of the vertices around [ATTR-60, ATTR-61].
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "base/simd/four_ints.h"
#include "positions/surroundings.h"

namespace deltamesh {

inline constexpr std::size_t kInfluences = 4;  ///< joints of a vertex

/// The joints of a vertex, below 2^16, in the source's order.
using JointRow = std::array<std::int32_t, kInfluences>;

/// Whether the first `count` joints are the same.
inline bool begins_alike(const JointRow& a, const JointRow& b, std::size_t count) noexcept {
  const unsigned differ = set_lanes(std::bit_cast<FourInts>(a) != std::bit_cast<FourInts>(b));
  return (differ & ((1U << count) - 1)) == 0;
}

/// Stable, the largest first; for a few dozen at most.
template <class T, class Size>
void sort_few(std::span<T> items, Size size) noexcept {
  for (std::size_t i = 1; i < items.size(); ++i)
    for (std::size_t k = i; k > 0 && size(items[k]) > size(items[k - 1]); --k)
      std::swap(items[k], items[k - 1]);
}

/// The different rows at the corners of known faces, most frequent first; ties: first met first.
class RowsAround {
 public:
  static constexpr std::size_t kMost = std::size_t{3} * Surroundings::kMostKnown;

  RowsAround(const Surroundings& around, std::span<const JointRow> rows) noexcept {
    for (unsigned i = 0; i < around.known_count; ++i) {
      const auto& [a, b, opposite] = around.known[i];
      add(rows[a]);
      add(rows[b]);
      if (opposite != kNoVertex) add(rows[opposite]);
    }
    sort_few(std::span(entries_.data(), count_), [](const Entry& entry) { return entry.times; });
  }

  struct Entry {
    JointRow row;
    std::uint32_t times;
  };
  std::span<const Entry> entries() const noexcept { return {entries_.data(), count_}; }
  /// One more than the place of `row`, or 0.
  unsigned symbol_of(const JointRow& row) const noexcept {
    for (unsigned i = 0; i < count_; ++i)
      if (begins_alike(entries_[i].row, row, kInfluences)) return i + 1;
    return 0;
  }

 private:
  void add(const JointRow& row) noexcept {
    const unsigned symbol = symbol_of(row);
    if (symbol == 0) {
      entries_[count_] = {.row = row, .times = 1};
      ++count_;
    } else {
      ++entries_[symbol - 1].times;
    }
  }

  std::array<Entry, kMost> entries_;
  unsigned count_ = 0;
};

/// Joints that a slot may have, likeliest first.
class SlotGuesses {
 public:
  static constexpr std::size_t kMost = 14;

  /// `coded`: the slots of `row` that are known.
  SlotGuesses(const RowsAround& around, const JointRow& row, std::size_t coded) noexcept {
    const auto begin = row.begin();
    const auto end = begin + static_cast<std::ptrdiff_t>(coded);
    for (const RowsAround::Entry& entry : around.entries()) {
      const bool fits = begins_alike(row, entry.row, coded);
      for (std::size_t slot = 0; slot < kInfluences; ++slot)
        add(entry.row[slot], entry.times * (slot != coded ? kOtherSlot : fits ? kSameBeginning : kSameSlot));
    }
    for (std::size_t i = 0; i < count_; ++i)
      if (std::find(begin, end, guesses_[i].joint) != end && row[coded - 1] != guesses_[i].joint)
        guesses_[i].score /= kUsed;
    sort_few(std::span(guesses_.data(), count_), [](const Guess& guess) { return guess.score; });
    count_ = std::min(count_, kMost);
  }

  std::size_t count() const noexcept { return count_; }
  std::int32_t at(std::size_t place) const noexcept { return guesses_[place].joint; }
  /// count() where it is not there.
  std::size_t place_of(std::int32_t joint) const noexcept {
    std::size_t place = 0;
    while (place < count_ && guesses_[place].joint != joint) ++place;
    return place;
  }
  /// How far the first is ahead of the second, 0 to 3.
  unsigned lead() const noexcept {
    if (count_ < 2) return 3;
    const std::uint32_t second = guesses_[1].score;
    return (guesses_[0].score >= 2 * second ? 1U : 0U) + (guesses_[0].score >= 4 * second ? 1U : 0U);
  }

 private:
  static constexpr std::uint32_t kOtherSlot = 4;  ///< weights of a neighbour's slots
  static constexpr std::uint32_t kSameSlot = 16;
  static constexpr std::uint32_t kSameBeginning = 48;  ///< where the slots before are the same as well
  static constexpr std::uint32_t kUsed = 32;           ///< divisor for a joint that a slot before has

  struct Guess {
    std::int32_t joint;
    std::uint32_t score;
  };

  void add(std::int32_t joint, std::uint32_t score) noexcept {
    std::size_t place = 0;
    while (place < count_ && guesses_[place].joint != joint) ++place;
    if (place == count_) guesses_[count_++] = {.joint = joint, .score = 0};
    guesses_[place].score += score;
  }

  std::array<Guess, RowsAround::kMost * kInfluences> guesses_;
  std::size_t count_ = 0;
};

}  // namespace deltamesh
