// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Reads compact streams whose decisions come in pairs, without a branch on whether a word is due [CMP-*].
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "deltamesh/result.h"
#include "entropy/compact_model.h"
#include "entropy/quick_models.h"

namespace deltamesh {

/// Reads what PairWriter wrote. Who calls says which of the two states is at turn. Past the end words are
/// made up and failed() stays set; finish() reports it and is mandatory. The first arguments of symbol() and
/// bits() are ignored: they make them callable like the writer's.
class PairReader {
 public:
  static constexpr bool kWrites = false;

  explicit PairReader(std::span<const std::byte> bytes) noexcept;

  /// A symbol of one model, after raw bits that come in the same decision [CMP-13].
  template <unsigned kState>
  [[gnu::always_inline]] unsigned symbol(unsigned, LowBits& low, const QuickModels& models,
                                         std::size_t model) noexcept {
    std::uint64_t state = states_[kState];
    low.value = static_cast<std::uint32_t>(state) & ((1U << low.count) - 1);
    state >>= low.count;
    const std::uint32_t slot = static_cast<std::uint32_t>(state) & (kProbabilityOne - 1);
    const unsigned symbol = models.find(model, slot);
    const Interval interval = models.interval(model, symbol);
    advance<kState>(interval.size * (state >> kProbabilityBits) + slot - interval.start);
    return symbol;
  }

  /// At most kMostBitsAtOnce bits.
  template <unsigned kState>
  [[gnu::always_inline]] std::uint32_t bits(std::uint32_t, unsigned count) noexcept {
    const std::uint64_t state = states_[kState];
    advance<kState>(state >> count);
    return static_cast<std::uint32_t>(state) & ((1U << count) - 1);
  }

  /// True as soon as a word was missing: what came since is made up. Loops over symbols ask every so often.
  bool failed() const noexcept { return position_ > bytes_.size(); }

  /// Every word is used and the states are back where the writer began. `begin`: where in the chunk the bytes
  /// do. Errors: kTruncated, kInvalidStream [CMP-3].
  Result<void> finish(std::uint32_t chunk_tag, std::size_t begin) const noexcept;

 private:
  template <unsigned kState>
  [[gnu::always_inline]] void advance(std::uint64_t state) noexcept {
    const std::uint64_t longer = state << 32 | word_at(std::min(position_, last_word_));
    const std::uint64_t if_due = state < kRansFloor ? ~std::uint64_t{0} : 0;
    states_[kState] = state ^ ((state ^ longer) & if_due);
    position_ += if_due & 4;
  }

  [[gnu::always_inline]] std::uint32_t word_at(std::size_t position) const noexcept {
    std::uint32_t word = 0;
    if constexpr (std::endian::native == std::endian::little) {
      std::memcpy(&word, bytes_.data() + position, sizeof(word));
    } else {
      for (unsigned i = 0; i < 4; ++i)
        word |= std::to_integer<std::uint32_t>(bytes_[position + i]) << (8 * i);
    }
    return word;
  }

  std::span<const std::byte> bytes_;
  std::size_t position_ = 0;   ///< behind all bytes where some were missing
  std::size_t last_word_ = 0;  ///< position of the last word
  std::array<std::uint64_t, 2> states_ = {kRansFloor, kRansFloor};
};

}  // namespace deltamesh
