// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The compact coder's reading side [CMP-*].
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "base/machine.h"
#include "deltamesh/result.h"
#include "entropy/coder/model.h"
#include "entropy/coder/number_model.h"

namespace deltamesh {

/// Reads what CompactWriter wrote. Where words are missing failed() is soon set and stays so; finish()
/// reports it and is mandatory. The first argument of symbol(), bit(), bits() and number() is ignored: it
/// makes them callable like the writer's.
class CompactReader {
 public:
  static constexpr bool kWrites = false;

  explicit CompactReader(std::span<const std::byte> bytes) noexcept;

  template <std::size_t K>
  [[gnu::always_inline]] unsigned symbol(unsigned, const Mixture<K>& mixture) noexcept {
    const LaneSum starts = mixture.starts();
    const unsigned symbol = starts.find(static_cast<std::int16_t>(slot_of_state()));
    const Interval interval = interval_of(starts, symbol);
    take(interval);
    mixture.learn(symbol, interval.size);
    return symbol;
  }

  /// A symbol and the bits that follow it, in one step [CMP-12].
  template <std::size_t K>
  [[gnu::always_inline]] unsigned symbol_and_bits(unsigned, LowBits& low, const Mixture<K>& mixture,
                                                  SymbolBits& bit_models) noexcept {
    const unsigned raw = low.count - (low.count > 0 ? 1 : 0);
    low.value = static_cast<std::uint32_t>(state_) & ((1U << raw) - 1);
    state_ >>= raw;
    const LaneSum starts = mixture.starts();
    const unsigned symbol = starts.find(static_cast<std::int16_t>(slot_of_state()));
    const Interval interval = interval_of(starts, symbol);
    Interval taken = interval;
    if (low.count > 0) {
      InnerBit& model = bit_models[symbol];
      const std::uint32_t set = model.size_of_set(interval.size);
      // Without a branch, which would go wrong every other time.
      const auto if_set =
          static_cast<std::uint32_t>(static_cast<std::int32_t>(slot_of_state() - interval.start - set) >> 31);
      taken = part_for_bit(interval, set, if_set);
      low.value |= (if_set & 1) << raw;
      model.learn(if_set);
    }
    take(taken);
    mixture.learn(symbol, interval.size);
    return symbol;
  }

  /// `model`: BitModel or CountedBit.
  template <class Model>
  [[gnu::always_inline]] bool bit(bool, Model& model) noexcept {
    const bool value = slot_of_state() < model.probability();
    take(model.interval(value));
    model.learn(value);
    return value;
  }

  [[gnu::always_inline]] std::uint32_t bits(std::uint32_t, unsigned count) noexcept {
    if (count <= kMostBitsAtOnce) return take_bits(count);
    const std::uint32_t low = take_bits(kMostBitsAtOnce);
    return low | take_bits(count - kMostBitsAtOnce) << kMostBitsAtOnce;
  }

  std::uint32_t number(std::uint32_t, NumberModel& model) noexcept { return code_number(*this, 0, model); }

  /// True where words are missing: what came since is made up. Loops over symbols ask every so often.
  bool failed() const noexcept { return failed_; }

  /// Every word is used and the states are back where the writer began. Errors: kTruncated, kInvalidStream
  /// [CMP-3].
  Result<void> finish(std::uint32_t chunk_tag) const noexcept;

 private:
  [[gnu::always_inline]] std::uint32_t slot_of_state() const noexcept {
    return static_cast<std::uint32_t>(state_) & (kProbabilityOne - 1);
  }

  [[gnu::always_inline]] void take(Interval interval) noexcept {
    advance(interval.size * (state_ >> kProbabilityBits) + slot_of_state() - interval.start);
  }

  [[gnu::always_inline]] std::uint32_t take_bits(unsigned count) noexcept {
    const auto value = static_cast<std::uint32_t>(state_) & ((1U << count) - 1);
    advance(state_ >> count);
    return value;
  }

  [[gnu::always_inline]] void advance(std::uint64_t state) noexcept {
    if (state < kRansFloor) state = refill(state);
    state_ = next_state_;
    next_state_ = state;
  }

  /// `state` with a word behind it, if there is one.
  [[gnu::always_inline]] std::uint64_t refill(std::uint64_t state) noexcept {
    if (bytes_.size() - position_ < 4) {
      failed_ |= state < kLeastState;
      return state;
    }
    std::uint32_t word = 0;
    std::memcpy(&word, bytes_.data() + position_, sizeof(word));
    position_ += sizeof(word);
    return state << 32 | word;
  }

  std::span<const std::byte> bytes_;
  std::size_t position_ = 0;
  std::uint64_t state_ = kLeastState;       ///< of the next symbol
  std::uint64_t next_state_ = kLeastState;  ///< of the symbol after it
  bool failed_ = false;
};

}  // namespace deltamesh
