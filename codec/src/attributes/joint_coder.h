// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The joints that vertices hang on, from those of the vertices around [ATTR-60, ATTR-61]. One template for
// both directions.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/four_ints.h"
#include "base/zigzag.h"
#include "entropy/number_model.h"
#include "entropy/symbol_models.h"
#include "predictive/surroundings.h"

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

/// What the corners of known faces have: different rows, most frequent first, of equally frequent ones the
/// first met.
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

/// Joints by how lately they were coded so; new ones by their difference to the one before.
template <class Coder>
class RecentJoints {
 public:
  explicit RecentJoints(Coder& coder) : coder_(coder) {}

  /// A joint, which a reader gets; any value where the stream is invalid.
  std::int64_t code(std::int32_t joint) {
    const auto found =
        static_cast<std::uint32_t>(std::find(recent_.begin(), recent_.end(), joint) - recent_.begin());
    const std::uint32_t place = coder_.number(found, places_);
    if (place < recent_.size()) {
      const auto at = recent_.begin() + place;
      std::rotate(recent_.begin(), at, at + 1);
      return recent_.front();
    }
    const std::int32_t step = unzigzag(coder_.number(zigzag(joint - last_new_), news_));
    const std::int64_t result = std::int64_t{last_new_} + step;
    if (result < 0 || result > 0xffff) return -1;
    last_new_ = static_cast<std::int32_t>(result);
    if (recent_.size() == kKept) recent_.pop_back();
    recent_.insert(recent_.begin(), last_new_);
    return result;
  }

 private:
  static constexpr std::size_t kKept = 256;

  Coder& coder_;
  std::vector<std::int32_t> recent_;
  std::int32_t last_new_ = 0;
  NumberModel places_;
  NumberModel news_;
};

template <class Coder>
class JointCoder {
 public:
  /// `most`: what a joint may be.
  JointCoder(Coder& coder, const KnownFaces& faces, std::uint32_t most)
      : coder_(coder), faces_(faces), most_(most), recent_(coder) {}

  /// Codes rows[vertex], those before it being coded; a reader fills it in. False where a joint is too large.
  bool code_vertex(std::uint32_t vertex, std::span<JointRow> rows) {
    const Surroundings around = faces_.around(vertex);
    const RowsAround known(around, rows);
    JointRow& row = rows[vertex];
    const auto entries = known.entries();
    const auto listed = static_cast<unsigned>(std::min<std::size_t>(entries.size(), kMostRows));
    if (listed > 0) {
      unsigned symbol = Coder::kWrites ? known.symbol_of(row) : 0;
      if (symbol > listed) symbol = 0;
      const unsigned lead = std::min(entries[0].times - (listed > 1 ? entries[1].times : 0), 4U);
      symbol = coder_.symbol(symbol, Mixture<2>{{&row_models_[0][listed * 5 + lead],
                                                 &row_models_[1][listed * 7 + std::min(around.faces, 6U)]},
                                                &row_weights_});
      if (symbol > 0 && symbol <= listed) {
        row = entries[symbol - 1].row;
        return true;
      }
    }
    return code_slots(known, row);
  }

 private:
  static constexpr std::size_t kMostRows = 7;
  static constexpr std::size_t kRowContexts = kMostRows + 1;
  static constexpr unsigned kOther = 15;
  static constexpr SymbolModel kFreshRow{{6, 12, 4, 3, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}};
  static constexpr SymbolModel kFreshSlot{{16, 6, 4, 3, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 6}};

  bool code_slots(const RowsAround& known, JointRow& row) {
    unsigned before = 0;
    for (std::size_t slot = 0; slot < kInfluences; ++slot) {
      const SlotGuesses guesses(known, row, slot);
      const auto count = static_cast<unsigned>(guesses.count());
      unsigned symbol = kOther;
      if constexpr (Coder::kWrites) {
        const std::size_t place = guesses.place_of(row[slot]);
        if (place < count) symbol = static_cast<unsigned>(place);
      }
      const auto base = static_cast<unsigned>(16 * slot);
      symbol =
          coder_.symbol(symbol, Mixture<2>{{&slot_models_[0][base + 4 * std::min(count, 3U) + guesses.lead()],
                                            &slot_models_[1][base + before]},
                                           &slot_weights_});
      before = symbol;
      if (symbol < count) {
        row[slot] = guesses.at(symbol);
        continue;
      }
      const std::int64_t joint = recent_.code(row[slot]);
      if (joint < 0 || joint > std::int64_t{most_}) return false;
      row[slot] = static_cast<std::int32_t>(joint);
    }
    return true;
  }

  Coder& coder_;
  const KnownFaces& faces_;
  std::uint32_t most_;
  RecentJoints<Coder> recent_;
  std::array<SymbolModels, 2> row_models_{SymbolModels(kRowContexts * 5, kFreshRow),
                                          SymbolModels(kRowContexts * 7, kFreshRow)};
  std::array<SymbolModels, 2> slot_models_{SymbolModels(kInfluences * 16, kFreshSlot),
                                           SymbolModels(kInfluences * 16, kFreshSlot)};
  MixWeights<2> row_weights_;
  MixWeights<2> slot_weights_;
};

}  // namespace deltamesh
