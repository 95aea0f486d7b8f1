// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Vectors of small integers at the vertices of a graph, coded in the context of the neighbours that are coded
// already [FLD-*]. One template for both directions.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "entropy/compact_model.h"
#include "entropy/number_model.h"
#include "field/field_predictor.h"
#include "topology/adjacency.h"

namespace deltamesh {

inline constexpr std::int32_t kLargestFieldValue = 1 << 30;  ///< either sign [FLD-1]

inline constexpr unsigned kFieldEscape = 15;
constexpr std::int64_t kFieldReach = 7;  ///< symbols 0 to 14 stand for -7 to 7
constexpr unsigned kLongTail = 7;        ///< bit lengths from here on are written out
inline constexpr SymbolModel kFreshField({1, 2, 3, 4, 8, 14, 24, 40, 24, 14, 8, 4, 3, 2, 1, 3});
inline constexpr SymbolModel kFreshTail({12, 8, 10, 7, 8, 5, 6, 4, 4, 3, 3, 2, 2, 1, 1, 1});

/// `Coder` is CompactWriter or CompactReader. `graph` must outlive the coder.
template <class Coder>
class FieldCoder {
 public:
  FieldCoder(Coder& coder, const Adjacency& graph) : coder_(coder), history_(graph) {
    for (std::size_t i = 0; i < models_.size(); ++i) models_[i].assign(kFieldContexts[i], kFreshField);
    tails_.assign(kTailContexts, kFreshTail);
  }

  /// Codes the first `axes` (1 to 3) numbers of `q` for `vertex`, the others being 0; all vertices before it
  /// are done. A reader fills them in. False where one is beyond kLargestFieldValue [FLD-1].
  bool code_vertex(std::uint32_t vertex, std::array<std::int32_t, 3>& q, unsigned axes,
                   const FieldHint* hint = nullptr) {
    const FieldNeighborhood around = history_.around(vertex);
    predictor_.begin(around, hint);
    if (!code_axis<0>(q[0])) return false;
    if (axes > 1 && !code_axis<1>(q[1])) return false;
    if (axes > 2 && !code_axis<2>(q[2])) return false;
    history_.remember(vertex, q, around);
    return true;
  }

  /// The same for a coder that tells prices: every number is `choose(axis, price)`, where price(q) is what
  /// coding q would cost in bits here and now.
  template <class Choose>
  std::array<std::int32_t, 3> choose_vertex(std::uint32_t vertex, Choose choose) {
    const FieldNeighborhood around = history_.around(vertex);
    predictor_.begin(around, nullptr);
    const std::array<std::int32_t, 3> q = {choose_axis<0>(choose), choose_axis<1>(choose),
                                           choose_axis<2>(choose)};
    history_.remember(vertex, q, around);
    return q;
  }

 private:
  template <unsigned kAxis>
  bool code_axis(std::int32_t& q) {
    const FieldForecast forecast = predictor_.template forecast<kAxis>();
    const std::int64_t coded = code(q, forecast);
    if (coded < -kLargestFieldValue || coded > kLargestFieldValue) return false;
    q = static_cast<std::int32_t>(coded);
    predictor_.template learn<kAxis>(q, forecast);
    return true;
  }

  template <unsigned kAxis, class Choose>
  std::int32_t choose_axis(Choose& choose) {
    const FieldForecast forecast = predictor_.template forecast<kAxis>();
    const std::int32_t q = choose(kAxis, [&](std::int32_t candidate) {
      const auto trial = coder_.trial();
      code(candidate, forecast);
      return trial.bits();
    });
    code(q, forecast);
    predictor_.template learn<kAxis>(q, forecast);
    return q;
  }

  /// Returns the number, of any size where the stream lies [FLD-5].
  [[gnu::always_inline]] std::int64_t code(std::int64_t q, const FieldForecast& f) {
    const std::int64_t swapped = (q ^ f.sign) - f.sign;
    std::int64_t high = (swapped >> f.shift) - f.center;
    const auto low = static_cast<std::uint32_t>(swapped & ((std::int64_t{1} << f.shift) - 1));
    const bool far = high < -kFieldReach || high > kFieldReach;
    const unsigned symbol = coder_.symbol(
        far ? kFieldEscape : static_cast<unsigned>(high + kFieldReach),
        Mixture<kFieldModels>{
            {&models_[0][f.contexts[0]], &models_[1][f.contexts[1]], &models_[2][f.contexts[2]]},
            &weights_[f.weight_set]});
    high = symbol == kFieldEscape ? code_tail(high, f) : static_cast<std::int64_t>(symbol) - kFieldReach;
    const std::int64_t result = ((high + f.center) << f.shift) | code_low(low, f.shift, symbol);
    return (result ^ f.sign) - f.sign;
  }

  /// Beyond the symbols: sign and bit length of the excess, then its bits [FLD-6].
  std::int64_t code_tail(std::int64_t high, const FieldForecast& f) {
    const auto excess = static_cast<std::uint32_t>(std::llabs(high) - (kFieldReach + 1));
    auto length = static_cast<unsigned>(std::bit_width(excess));
    const unsigned symbol = coder_.symbol(std::min(length, kLongTail) * 2 + (high < 0 ? 1 : 0),
                                          Mixture<1>{{&tails_[f.tail_context]}, &tail_weights_});
    const bool negative = symbol % 2 != 0;
    length = symbol / 2;
    if (length == kLongTail)
      length += coder_.bits(static_cast<unsigned>(std::bit_width(excess)) - kLongTail, 5);
    length = std::min(length, 32U);
    const std::uint32_t coded =
        length == 0 ? 0 : code_mantissa(coder_, excess, length, tail_second_[length], tail_third_[length]);
    const std::int64_t size = std::int64_t{coded} + kFieldReach + 1;
    return negative ? -size : size;
  }

  /// The highest of the low bits by a model, the others as they are [FLD-5].
  std::int64_t code_low(std::uint32_t low, unsigned shift, unsigned symbol) {
    if (shift == 0) return 0;
    const bool top = coder_.bit((low >> (shift - 1)) != 0, low_models_[symbol]);
    const std::uint32_t high = (top ? 1U : 0U) << (shift - 1);
    if (shift == 1) return high;
    return std::int64_t{high} | coder_.bits(low & ((1U << (shift - 1)) - 1), shift - 1);
  }

  Coder& coder_;
  FieldHistory history_;
  FieldPredictor predictor_;
  std::array<std::vector<SymbolModel>, kFieldModels> models_;
  std::array<MixWeights<kFieldModels>, kFieldWeightSets> weights_;
  std::vector<SymbolModel> tails_;
  MixWeights<1> tail_weights_;
  std::array<BitModel, 33> tail_second_;
  std::array<std::array<BitModel, 2>, 33> tail_third_;
  std::array<BitModel, kSymbols> low_models_;
};

}  // namespace deltamesh
