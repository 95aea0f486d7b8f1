// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Vectors of small integers at the vertices of a graph, coded in the context of the neighbours that are coded
// already [FLD-*]. One template for both directions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "entropy/split_number.h"
#include "field/field_predictor.h"
#include "topology/adjacency.h"

namespace deltamesh {

inline constexpr std::int32_t kLargestFieldValue = 1 << 30;  ///< either sign [FLD-1]

using FieldNumbers = std::array<std::int32_t, 3>;

/// Where the second of two walks begins that take turns [FLD-8].
constexpr std::uint32_t middle_of(std::uint32_t vertices) noexcept { return vertices - vertices / 2; }

/// `Coder` is CompactWriter, CompactReader or CompactPricer. `graph` must outlive the coder.
template <class Coder>
class FieldCoder {
 public:
  /// One walk over all vertices.
  FieldCoder(Coder& coder, const Adjacency& graph)
      : FieldCoder(coder, graph, static_cast<std::uint32_t>(graph.vertex_count())) {}
  /// Two walks, the second of which begins at `middle` [FLD-8].
  FieldCoder(Coder& coder, const Adjacency& graph, std::uint32_t middle)
      : coder_(coder), history_(graph, middle), numbers_(coder) {
    for (std::size_t i = 0; i < models_.size(); ++i) models_[i].assign(kFieldContexts[i], kFreshSplit);
  }

  /// Codes the first `axes` (1 to 3) numbers of `q` for `vertex`, the others being 0; all vertices before it
  /// are done. A reader fills them in. False where one is beyond kLargestFieldValue [FLD-1].
  bool code_vertex(std::uint32_t vertex, FieldNumbers& q, unsigned axes, const FieldHint* hint = nullptr) {
    FieldPredictor predictor(history_.around(vertex), hint);
    if (!code_axis<0>(predictor, q)) return false;
    if (axes > 1 && !code_axis<1>(predictor, q)) return false;
    if (axes > 2 && !code_axis<2>(predictor, q)) return false;
    predictor.teach(weights_);
    history_.remember(vertex, predictor.numbers(), predictor.around());
    return true;
  }

  /// The same for the next vertices of both walks, number by number in turns: what takes its time for one
  /// vertex need not wait for the other, nor for weights that learn from it [FLD-8].
  bool code_pair(std::uint32_t first, std::uint32_t second, FieldNumbers& q, FieldNumbers& p) {
    FieldPredictor a(history_.around(first), nullptr);
    FieldPredictor b(history_.around(second), nullptr);
    Held coder = coder_;
    const bool is_valid =
        code_axes<0>(coder, a, b, q, p) && code_axes<1>(coder, a, b, q, p) && code_axes<2>(coder, a, b, q, p);
    give_back(coder);
    if (!is_valid) return false;
    a.teach(weights_);
    history_.remember(first, a.numbers(), a.around());
    history_.remember(second, b.numbers(), b.around());
    return true;
  }

  /// The same for a coder that tells prices: every number is `choose(axis, price)`, where price(q) is what
  /// coding q would cost in bits here and now.
  template <class Choose>
  FieldNumbers choose_vertex(std::uint32_t vertex, Choose choose) {
    FieldPredictor predictor(history_.around(vertex), nullptr);
    const FieldNumbers q = {choose_axis<0>(predictor, choose), choose_axis<1>(predictor, choose),
                            choose_axis<2>(predictor, choose)};
    predictor.teach(weights_);
    history_.remember(vertex, predictor.numbers(), predictor.around());
    return q;
  }

 private:
  using Weights = MixWeights<kFieldModels>;

  /// What a pair is coded with: a reader's copy, which a compiler can keep in registers, or a writer.
  using Held = std::conditional_t<Coder::kWrites, Coder&, Coder>;
  void give_back(const Coder& coder) noexcept {
    if constexpr (!Coder::kWrites) coder_ = coder;
  }

  template <unsigned kAxis>
  [[gnu::always_inline]] bool code_axis(FieldPredictor& predictor, FieldNumbers& q) {
    const FieldForecast forecast = predictor.template forecast<kAxis>(weights_);
    Weights& weights = mixes_[forecast.weight_set];
    const std::int64_t coded = code(coder_, q[kAxis], forecast, weights, &weights);
    return settle<kAxis>(predictor, q, coded);
  }

  template <unsigned kAxis>
  [[gnu::always_inline]] bool code_axes(Coder& coder, FieldPredictor& a, FieldPredictor& b, FieldNumbers& q,
                                        FieldNumbers& p) {
    const FieldForecast of_a = a.template forecast<kAxis>(weights_);
    const FieldForecast of_b = b.template forecast<kAxis>(weights_);
    Weights& weights_a = mixes_[of_a.weight_set];
    const Weights weights_b = mixes_[of_b.weight_set];
    const std::int64_t coded_q = code(coder, q[kAxis], of_a, weights_a, &weights_a);
    const std::int64_t coded_p = code(coder, p[kAxis], of_b, weights_b, nullptr);
    return settle<kAxis>(a, q, coded_q) && settle<kAxis>(b, p, coded_p);
  }

  template <unsigned kAxis>
  [[gnu::always_inline]] static bool settle(FieldPredictor& predictor, FieldNumbers& q, std::int64_t coded) {
    if (coded < -kLargestFieldValue || coded > kLargestFieldValue) return false;
    q[kAxis] = static_cast<std::int32_t>(coded);
    predictor.template settle<kAxis>(q[kAxis]);
    return true;
  }

  template <unsigned kAxis, class Choose>
  std::int32_t choose_axis(FieldPredictor& predictor, Choose& choose) {
    const FieldForecast forecast = predictor.template forecast<kAxis>(weights_);
    Weights& weights = mixes_[forecast.weight_set];
    const std::int32_t q = choose(kAxis, [&](std::int32_t candidate) {
      const auto trial = coder_.trial();
      code(coder_, candidate, forecast, weights, &weights);
      return trial.bits();
    });
    code(coder_, q, forecast, weights, &weights);
    predictor.template settle<kAxis>(q);
    return q;
  }

  /// Returns the number, of any size where the stream lies [FLD-5].
  [[gnu::always_inline]] std::int64_t code(Coder& coder, std::int64_t q, const FieldForecast& f,
                                           const Weights& weights, Weights* learning) {
    if (f.shift > kMostLowBits) __builtin_unreachable();  // no magnitude is above 2^18 sixteenths
    const auto model = [&](std::size_t k) { return &models_[k][f.contexts[k]]; };
    const Mixture<kFieldModels> mixture({model(0), model(1), model(2)}, weights, learning);
    const std::int64_t result = numbers_.code(coder, (q ^ f.sign) - f.sign, f.shift, mixture);
    return (result ^ f.sign) - f.sign;
  }

  Coder& coder_;
  FieldHistory history_;
  FieldWeights weights_;
  std::array<std::vector<SymbolModel>, kFieldModels> models_;
  std::array<Weights, kFieldWeightSets> mixes_;
  SplitNumberCoder<Coder> numbers_;
};

}  // namespace deltamesh
