// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Reads compact streams whose decisions come in pairs, without a branch on whether a word is due [CMP-*].
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "deltamesh/result.h"
#include "entropy/compact_model.h"
#include "entropy/quick_models.h"

namespace deltamesh {

/// The bytes of a stream, and behind them as many words of 0 as may be read before failed() is asked, and one
/// more, as a position beyond the end is not that of a word.
class PairBytes {
 public:
  static constexpr std::size_t kWordsUnasked = 32;

  explicit PairBytes(std::span<const std::byte> bytes) : size_(bytes.size()) {
    padded_.reserve(size_ + kPadding);
    padded_.assign(bytes.begin(), bytes.end());
    padded_.resize(size_ + kPadding);
  }

  const std::byte* data() const noexcept { return padded_.data(); }
  std::size_t size() const noexcept { return size_; }

 private:
  static constexpr std::size_t kPadding = 4 * (kWordsUnasked + 1);

  std::vector<std::byte> padded_;
  std::size_t size_;
};

/// Reads what PairWriter wrote. Who calls says which of the two states is at turn, and asks failed() at least
/// every kWordsUnasked decisions. Once it is set what comes is made up; finish() reports it and is mandatory.
/// The first arguments of symbol() and bits() are ignored: they make them callable like the writer's.
class PairReader {
 public:
  static constexpr bool kWrites = false;

  /// `bytes` must outlive this.
  explicit PairReader(const PairBytes& bytes) noexcept;

  /// A symbol of one model, after raw bits that come in the same decision [CMP-13].
  template <unsigned kState>
  [[gnu::always_inline]] unsigned symbol(unsigned, LowBits& low, const QuickModel& model) noexcept {
    std::uint64_t state = states_[kState];
    low.value = static_cast<std::uint32_t>(state) & ((1U << low.count) - 1);
    state >>= low.count;
    const std::uint32_t slot = static_cast<std::uint32_t>(state) & (kProbabilityOne - 1);
    const unsigned symbol = model.find(slot);
    const Interval interval = model.interval(symbol);
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

  /// A word was missing: what came since is made up.
  bool failed() const noexcept { return next_ > end_; }

  /// Every word is used and the states are back where the writer began. `begin`: where in the chunk the bytes
  /// do. Errors: kTruncated, kInvalidStream [CMP-3].
  Result<void> finish(std::uint32_t chunk_tag, std::size_t begin) const noexcept;

 private:
  template <unsigned kState>
  [[gnu::always_inline]] void advance(std::uint64_t state) noexcept {
    const std::uint64_t longer = state << 32 | word();
    const std::uint64_t if_due = state < kRansFloor ? ~std::uint64_t{0} : 0;
    states_[kState] = state ^ ((state ^ longer) & if_due);
    next_ += if_due & 4;
  }

  [[gnu::always_inline]] std::uint32_t word() const noexcept {
    std::uint32_t word = 0;
    if constexpr (std::endian::native == std::endian::little) {
      std::memcpy(&word, next_, sizeof(word));
    } else {
      for (unsigned i = 0; i < 4; ++i) word |= std::to_integer<std::uint32_t>(next_[i]) << (8 * i);
    }
    return word;
  }

  const std::byte* begin_;
  const std::byte* end_;
  const std::byte* next_;  ///< behind the end where words were missing
  std::array<std::uint64_t, 2> states_ = {kRansFloor, kRansFloor};
};

}  // namespace deltamesh
