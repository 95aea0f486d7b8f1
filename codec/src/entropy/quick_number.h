// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Signed numbers that are mostly near 0, one decision each but for those that are far away [CMP-14].
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "entropy/quick_models.h"

namespace deltamesh {

/// `Coder` is PairReader or PairWriter.
template <class Coder>
class QuickNumberCoder {
 public:
  static constexpr unsigned kEscape = 7;  ///< in the place of -8; 0 is the last

  /// `models` are of the symbols, `contexts` of those that come after an escape.
  QuickNumberCoder(Coder& coder, std::size_t models, std::size_t contexts)
      : coder_(coder), models_(models, QuickModel(kFresh)), tails_(contexts, QuickModel(kFreshTail)) {}

  /// Codes `value` by `value >> shift`, in `model`, and its low `shift` (0 to 16) bits, with state kState; an
  /// escape takes two or four decisions more. A reader's argument is ignored; where the stream lies the
  /// result is anything below 2^62 in size. `coder`: that of the making, or a reader's copy that goes on in
  /// its place, and that a compiler can keep in registers.
  template <unsigned kState>
  [[gnu::always_inline]] std::int64_t code(Coder& coder, std::int64_t value, unsigned shift,
                                           std::size_t model, std::size_t context, unsigned& symbol) {
    std::int64_t high = value >> shift;
    LowBits low{.count = shift, .value = static_cast<std::uint32_t>(value) & ((1U << shift) - 1)};
    const bool far = high < -kReach || high > kReach;
    QuickModel& used = models_[model];
    symbol =
        coder.template symbol<kState>(far ? kEscape : static_cast<unsigned>(high - 1) % kSymbols, low, used);
    used.learn(symbol);
    if (symbol == kEscape) [[unlikely]]
      return (code_tail<kState>(coder, high, context) << shift) | low.value;
    return (static_cast<std::int32_t>((symbol + 1) << 28) >> 28 << shift) |
           static_cast<std::int32_t>(low.value);
  }

 private:
  static constexpr std::int64_t kReach = 7;
  static constexpr unsigned kLongTail = 7;  ///< bit lengths from here on are written out
  static constexpr unsigned kLengthBits = 5;
  static constexpr std::array<std::uint8_t, kSymbols> kFresh = {24, 14, 8, 4, 3, 2,  1,  3,
                                                                1,  2,  3, 4, 8, 14, 24, 40};
  static constexpr std::array<std::uint8_t, kSymbols> kFreshTail = {12, 8, 10, 7, 8, 5, 6, 4,
                                                                    4,  3, 3,  2, 2, 1, 1, 1};

  /// Beyond the symbols: sign and bit length of the excess, then its bits.
  template <unsigned kState>
  [[gnu::noinline]] std::int64_t code_tail(std::int64_t high, std::size_t context) {
    constexpr unsigned kOther = 1 - kState;
    const auto excess = static_cast<std::uint32_t>(std::llabs(high) - (kReach + 1));
    const auto length = static_cast<unsigned>(std::bit_width(excess));
    LowBits none;
    const unsigned symbol = coder_.template symbol<kOther>(
        std::min(length, kLongTail) * 2 + (high < 0 ? 1 : 0), none, tails_[context]);
    tails_[context].learn(symbol);
    const std::uint32_t coded =
        symbol / 2 < kLongTail ? code_short<kState>(excess, symbol / 2) : code_long<kState>(excess, length);
    const std::int64_t size = std::int64_t{coded} + kReach + 1;
    return symbol % 2 != 0 ? -size : size;
  }

  /// Of `length` bits, the leading one is not written.
  template <unsigned kState>
  std::uint32_t code_short(std::uint32_t excess, unsigned length) {
    if (length == 0) return coder_.template bits<kState>(0, 0);
    const std::uint32_t leading = 1U << (length - 1);
    return leading | coder_.template bits<kState>(excess & (leading - 1), length - 1);
  }

  template <unsigned kState>
  std::uint32_t code_long(std::uint32_t excess, unsigned length) {
    length = coder_.template bits<kState>(length, kLengthBits);
    const unsigned low = std::min(length, kMostBitsAtOnce);
    const std::uint32_t coded = coder_.template bits<1 - kState>(excess & ((1U << low) - 1), low);
    return coded | coder_.template bits<kState>(excess >> low, length - low) << low;
  }

  /// The same with any coder. A reader's copy stays in registers, as nothing points to it.
  template <unsigned kState>
  [[gnu::always_inline]] std::int64_t code_tail(Coder& coder, std::int64_t high, std::size_t context) {
    if constexpr (!Coder::kWrites) coder_ = coder;
    const std::int64_t result = code_tail<kState>(high, context);
    if constexpr (!Coder::kWrites) coder = coder_;
    return result;
  }

  Coder& coder_;
  std::vector<QuickModel> models_;
  std::vector<QuickModel> tails_;
};

}  // namespace deltamesh
