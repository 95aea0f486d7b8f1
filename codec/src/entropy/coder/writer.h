// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The compact coder's writing side: adaptive symbols, bits and numbers to bytes [CMP-*].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "entropy/coder/model.h"
#include "entropy/coder/number_model.h"

namespace deltamesh {

/// Collects symbols, which finish() turns into one rANS stream. The functions have the names and the
/// results of CompactReader's, so that one template serves both directions; here each returns its first
/// argument. Memory: 4 bytes per symbol until finish().
class CompactWriter {
 public:
  static constexpr bool kWrites = true;

  /// `value` below 16.
  template <std::size_t K>
  [[gnu::always_inline]] unsigned symbol(unsigned value, const Mixture<K>& mixture) {
    const Interval interval = interval_of(mixture.starts(), value);
    put(interval);
    mixture.learn(value, interval.size);
    return value;
  }

  /// `value` below 16; at most kMostBitsAtOnce + 1 bits.
  template <std::size_t K>
  [[gnu::always_inline]] unsigned symbol_and_bits(unsigned value, const LowBits& low,
                                                  const Mixture<K>& mixture, SymbolBits& bit_models) {
    if (low.count == 0) return symbol(value, mixture);
    const Interval interval = interval_of(mixture.starts(), value);
    InnerBit& model = bit_models[value];
    const unsigned raw = low.count - 1;
    const std::uint32_t if_set = 0 - (low.value >> raw);
    put_joined(low.value & ((1U << raw) - 1), raw);
    put(part_for_bit(interval, model.size_of_set(interval.size), if_set));
    model.learn(if_set);
    mixture.learn(value, interval.size);
    return value;
  }

  /// `model`: BitModel or CountedBit.
  template <class Model>
  bool bit(bool value, Model& model) {
    put(model.interval(value));
    model.learn(value);
    return value;
  }

  /// The lowest `count` (0 to 32) bits of `value`, the higher ones being 0.
  std::uint32_t bits(std::uint32_t value, unsigned count) {
    if (count > kMostBitsAtOnce) {
      put_bits(value & ((1U << kMostBitsAtOnce) - 1), kMostBitsAtOnce);
      put_bits(value >> kMostBitsAtOnce, count - kMostBitsAtOnce);
    } else {
      put_bits(value, count);
    }
    return value;
  }

  std::uint32_t number(std::uint32_t value, NumberModel& model) { return code_number(*this, value, model); }

  static constexpr bool failed() noexcept { return false; }

  /// The stream. The writer is empty afterwards. O(symbols).
  std::vector<std::byte> finish();

  /// Room for this many symbols, so that nothing moves while they come.
  void reserve(std::size_t symbols) { symbols_.reserve(symbols); }

 private:
  /// Marks bits among intervals, whose sizes are smaller.
  static constexpr std::uint32_t kBitsMark = 0x8000;
  /// Marks those bits that are read together with the interval that follows.
  static constexpr std::uint32_t kJoinedMark = 0x4000;

  void put(Interval interval) { symbols_.push_back(interval.start << 16 | interval.size); }
  void put_bits(std::uint32_t value, unsigned count) { symbols_.push_back(value << 16 | kBitsMark | count); }
  void put_joined(std::uint32_t value, unsigned count) {
    symbols_.push_back(value << 16 | kBitsMark | kJoinedMark | count);
    ++joined_;
  }

  using States = std::array<std::uint64_t, 2>;
  /// Turns symbols into words, which take the place of the last ones, from `first` on, and the states that
  /// a reader begins with. False, with nothing changed, where small states would need words at different
  /// times.
  bool encode(std::uint64_t begin, States& states, std::size_t& first);

  std::vector<std::uint32_t> symbols_;  ///< intervals and bits
  std::size_t joined_ = 0;              ///< how many of them go with the next
};

}  // namespace deltamesh
