// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The difference between a coordinate and its forecast [POSN-6, POSN-7]. One template for both directions.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "entropy/compact_model.h"
#include "entropy/number_model.h"
#include "predictive/residual_context.h"

namespace deltamesh {

/// `Coder` is CompactWriter or CompactReader.
template <class Coder>
class ResidualCoder {
 public:
  explicit ResidualCoder(Coder& coder) : coder_(coder) {
    for (std::size_t i = 0; i < models_.size(); ++i) models_[i].assign(kResidualContexts[i], kFreshResidual);
    tails_.assign(kResidualTails, kFreshExcess);
  }

  /// A reader's argument is ignored. Where the stream lies the result is anything below 2^62 in size.
  std::int64_t code(std::int64_t residual, const ResidualForecast& f) {
    const std::int64_t swapped = f.negative ? -residual : residual;
    std::int64_t high = swapped >> f.shift;
    const auto low = static_cast<std::uint32_t>(swapped & ((std::int64_t{1} << f.shift) - 1));
    const bool far = high < -kReach || high > kReach;
    const unsigned symbol = coder_.symbol(far ? kEscape : static_cast<unsigned>(high + kReach),
                                          Mixture<4>{{&models_[0][f.contexts[0]], &models_[1][f.contexts[1]],
                                                      &models_[2][f.contexts[2]], &models_[3][f.contexts[3]]},
                                                     &weights_[f.weight_set]});
    high = symbol == kEscape ? code_excess(high, f) : static_cast<std::int64_t>(symbol) - kReach;
    const std::int64_t result = (high << f.shift) | code_low(low, f.shift, symbol);
    return f.negative ? -result : result;
  }

 private:
  static constexpr unsigned kEscape = 15;
  static constexpr std::int64_t kReach = 7;  ///< symbols 0 to 14 stand for -7 to 7
  static constexpr unsigned kLong = 7;       ///< bit lengths from here on are written out
  static constexpr SymbolModel kFreshResidual{{1, 2, 3, 4, 8, 14, 24, 40, 24, 14, 8, 4, 3, 2, 1, 3}};
  static constexpr SymbolModel kFreshExcess{{12, 8, 10, 7, 8, 5, 6, 4, 4, 3, 3, 2, 2, 1, 1, 1}};

  /// Beyond the symbols: sign and bit length of the excess, then its bits.
  std::int64_t code_excess(std::int64_t high, const ResidualForecast& f) {
    const auto excess = static_cast<std::uint32_t>(std::llabs(high) - (kReach + 1));
    auto length = static_cast<unsigned>(std::bit_width(excess));
    const unsigned symbol = coder_.symbol(std::min(length, kLong) * 2 + (high < 0 ? 1 : 0),
                                          Mixture<1>{{&tails_[f.tail_context]}, &tail_weights_});
    length = symbol / 2 == kLong ? std::min(kLong + coder_.bits(length - kLong, 5), 32U) : symbol / 2;
    const std::uint32_t coded =
        length == 0 ? 0 : code_mantissa(coder_, excess, length, second_[length], third_[length]);
    const std::int64_t size = std::int64_t{coded} + kReach + 1;
    return symbol % 2 != 0 ? -size : size;
  }

  std::int64_t code_low(std::uint32_t low, unsigned shift, unsigned symbol) {
    if (shift == 0) return 0;
    const bool top = coder_.bit((low >> (shift - 1)) != 0, low_models_[symbol]);
    const std::uint32_t rest = coder_.bits(low & ((1U << (shift - 1)) - 1), shift - 1);
    return static_cast<std::int64_t>(top ? 1U << (shift - 1) | rest : rest);
  }

  Coder& coder_;
  std::array<std::vector<SymbolModel>, 4> models_;
  std::array<MixWeights<4>, kResidualWeightSets> weights_;
  std::vector<SymbolModel> tails_;
  MixWeights<1> tail_weights_;
  std::array<BitModel, 33> second_;
  std::array<std::array<BitModel, 2>, 33> third_;
  std::array<BitModel, kSymbols> low_models_;
};

}  // namespace deltamesh
