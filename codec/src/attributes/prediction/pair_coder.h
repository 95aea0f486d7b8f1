// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Pairs of small integers, what predictions were off by, in the context of how far apart the predictions are
// and of what was coded next to them [ATTR-37]. One template for both directions.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "entropy/coder/held_coder.h"
#include "entropy/coder/split_number.h"

namespace deltamesh {

using NumberPair = std::array<std::int32_t, 2>;

inline constexpr std::int32_t kLargestPairNumber = 1 << 24;  ///< either sign
inline constexpr std::uint32_t kPairUnit = 16;               ///< parts of a step
inline constexpr std::uint32_t kPairKinds = 5;

/// The context of a pair; sizes in 1/16 steps, at most 2^20.
struct PairContext {
  std::array<std::uint32_t, 2> near{};    ///< size of the numbers next to it
  std::array<std::uint32_t, 2> spread{};  ///< of the predictions
  std::uint32_t kind = 0;                 ///< below kPairKinds; 0 where nothing is known
};

/// `Coder` is CompactWriter or CompactReader.
template <class Coder>
class PairCoder {
 public:
  explicit PairCoder(Coder& coder) : coder_(coder), numbers_(coder) {}

  /// A reader fills `pair` in. False where a number is beyond kLargestPairNumber.
  bool code(NumberPair& pair, const PairContext& context) {
    Held<Coder> coder = coder_;
    const bool is_valid =
        (context.near[0] + context.near[1] < kMostlyZero && code_zero(coder, pair, context)) ||
        (code_axis(coder, pair[0], 0, 0, context) && code_axis(coder, pair[1], 1, pair[0], context));
    write_back<Coder>(coder, coder_);
    return is_valid;
  }

 private:
  static constexpr std::uint32_t kMostlyZero = 4;  ///< below, one bit for both numbers saves time
  static constexpr std::uint32_t kSpreads = 8;
  static constexpr std::uint32_t kSizes = 20;
  static constexpr std::uint32_t kBefores = 5;

  /// Two classes per octave of size + 4.
  static std::uint32_t size_class(std::uint32_t size) noexcept {
    const std::uint32_t v = size + 4;
    const auto octave = static_cast<unsigned>(std::bit_width(v)) - 3;
    return std::min(2 * octave + ((v >> (octave + 1)) & 1), kSizes - 1);
  }

  /// Whether both numbers are 0.
  [[gnu::always_inline]] bool code_zero(Coder& coder, NumberPair& pair, const PairContext& context) {
    const auto octave = static_cast<std::uint32_t>(std::bit_width(context.spread[0] + context.spread[1]));
    BitModel& model = zero_models_[std::min(octave, kSpreads - 1)];
    if (!coder.bit(pair == NumberPair{}, model)) return false;
    pair = {};
    return true;
  }

  [[gnu::always_inline]] bool code_axis(Coder& coder, std::int32_t& number, std::uint32_t axis,
                                        std::int32_t before, const PairContext& context) {
    const auto other = static_cast<std::uint32_t>(std::abs(before));
    const std::uint32_t near = context.near[axis];
    const std::uint32_t spread = context.spread[axis];
    const std::uint32_t scale = (8 * near + 6 * spread + 5 * kPairUnit * other) >> 4;
    const unsigned shift = static_cast<unsigned>(std::bit_width(scale | 127)) - 7;
    const std::uint32_t coded = axis + (axis != 0 ? std::min(other >> shift, 3U) : 0);
    const std::uint32_t scale_class = size_class(scale >> shift);
    const std::uint32_t is_shifted = shift != 0 ? 1 : 0;
    const Mixture<2> mixture{
        {&by_near_[(size_class(near >> shift) * kPairKinds + context.kind) * kBefores + coded],
         &by_spread_[(size_class(spread >> shift) * 2 + is_shifted) * kBefores + coded]},
        &mixes_[scale_class * 2 + axis]};
    const std::int64_t result = numbers_.code(coder, number, shift, mixture);
    if (result < -kLargestPairNumber || result > kLargestPairNumber) return false;
    number = static_cast<std::int32_t>(result);
    return true;
  }

  Coder& coder_;
  std::array<BitModel, kSpreads> zero_models_;
  std::vector<SymbolModel> by_near_ = std::vector(kSizes * kPairKinds * kBefores, kFreshSplit);
  std::vector<SymbolModel> by_spread_ = std::vector(kSizes * 2 * kBefores, kFreshSplit);
  std::array<MixWeights, kSizes * 2> mixes_;
  SplitNumberCoder<Coder> numbers_;
};

}  // namespace deltamesh
