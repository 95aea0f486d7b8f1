// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Signed numbers that are mostly near 0: a symbol in context, a tail for those that are not, and low
// bits below the symbol [CMP-15].
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "entropy/coder/held_coder.h"
#include "entropy/coder/model.h"
#include "entropy/coder/number_model.h"

namespace deltamesh {

/// Initial model of the symbols: 0 to 14 stand for -7 to 7, 15 for all other numbers.
inline constexpr SymbolModel kFreshSplit({1, 2, 3, 4, 8, 14, 24, 40, 24, 14, 8, 4, 3, 2, 1, 3});

inline constexpr unsigned kMostLowBits = kMostBitsAtOnce + 1;  ///< that come with the symbol

struct SplitNumberModels {
  BitModel is_below;  ///< of numbers beyond the symbols, and by how much
  NumberModel excess;
  SymbolBits low;

  void limit_counts(std::uint8_t most) noexcept { excess.length.limit_count(most); }
};

/// `Coder` is CompactWriter, CompactReader or CompactPricer.
template <class Coder>
class SplitNumberCoder {
 public:
  explicit SplitNumberCoder(Coder& coder, const SplitNumberModels& start = {}) noexcept
      : coder_(coder), models_(start) {}

  const SplitNumberModels& models() const noexcept { return models_; }

  /// Codes `value` by `value >> shift`, in `mixture`, and its low `shift` bits. A reader's argument is
  /// ignored; where the stream lies the result is anything below 2^62 in size. `coder`: that of the making,
  /// or a reader's copy that goes on in its place, and that a compiler can keep in registers.
  template <std::size_t kModels>
  [[gnu::always_inline]] std::int64_t code(Coder& coder, std::int64_t value, unsigned shift,
                                           const Mixture<kModels>& mixture) {
    const unsigned rest = shift > kMostLowBits ? shift - kMostLowBits : 0;
    std::int64_t high = value >> shift;
    LowBits low{.count = shift - rest, .value = low_bits(value >> rest, shift - rest)};
    const bool far = high < -kReach || high > kReach;
    const unsigned symbol = coder.symbol_and_bits(far ? kEscape : static_cast<unsigned>(high + kReach), low,
                                                  mixture, models_.low);
    if (symbol == kEscape) [[unlikely]] {
      high = code_tail(coder, high);
    } else {
      high = static_cast<std::int64_t>(symbol) - kReach;
    }
    const std::int64_t result = (high << low.count) | low.value;
    if (rest == 0) [[likely]]
      return result;
    return (result << rest) | code_rest(coder, low_bits(value, rest), rest);
  }

 private:
  static constexpr unsigned kEscape = 15;
  static constexpr std::int64_t kReach = 7;

  /// Beyond the symbols: the sign and how far [CMP-15].
  [[gnu::noinline]] std::int64_t code_tail(std::int64_t high) {
    const auto excess = static_cast<std::uint32_t>(std::llabs(high) - (kReach + 1));
    const bool is_below = coder_.bit(high < 0, models_.is_below);
    const std::int64_t size = std::int64_t{code_number(coder_, excess, models_.excess)} + kReach + 1;
    return is_below ? -size : size;
  }

  static std::uint32_t low_bits(std::int64_t value, unsigned count) noexcept {
    return static_cast<std::uint32_t>(value & ((std::int64_t{1} << count) - 1));
  }

  [[gnu::noinline]] std::uint32_t code_rest(std::uint32_t value, unsigned count) {
    return coder_.bits(value, count);
  }

  /// The same with any coder. A reader's copy stays in registers, as nothing points to it.
  [[gnu::always_inline]] std::int64_t code_tail(Coder& coder, std::int64_t high) {
    return with(coder, [&] { return code_tail(high); });
  }
  [[gnu::always_inline]] std::uint32_t code_rest(Coder& coder, std::uint32_t value, unsigned count) {
    return with(coder, [&] { return code_rest(value, count); });
  }
  template <class Code>
  [[gnu::always_inline]] auto with(Coder& coder, Code code) {
    write_back<Coder>(coder, coder_);
    const auto result = code();
    write_back<Coder>(coder_, coder);
    return result;
  }

  Coder& coder_;
  SplitNumberModels models_;
};

}  // namespace deltamesh
