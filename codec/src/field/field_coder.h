// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Vectors of small integers at the vertices of a graph, coded in the context of the neighbours that are coded
// already [FLD-*]. One template for both directions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "entropy/split_number.h"
#include "field/field_predictor.h"
#include "topology/adjacency.h"

namespace deltamesh {

inline constexpr std::int32_t kLargestFieldValue = 1 << 30;  ///< either sign [FLD-1]

/// `Coder` is CompactWriter or CompactReader. `graph` must outlive the coder.
template <class Coder>
class FieldCoder {
 public:
  FieldCoder(Coder& coder, const Adjacency& graph)
      : coder_(coder), history_(graph), numbers_(coder, kTailContexts) {
    for (std::size_t i = 0; i < models_.size(); ++i) models_[i].assign(kFieldContexts[i], kFreshSplit);
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
    const Mixture<kFieldModels> mixture{
        {&models_[0][f.contexts[0]], &models_[1][f.contexts[1]], &models_[2][f.contexts[2]]},
        &weights_[f.weight_set]};
    const std::int64_t result = numbers_.code(swapped, f.shift, f.center, mixture, f.tail_context);
    return (result ^ f.sign) - f.sign;
  }

  Coder& coder_;
  FieldHistory history_;
  FieldPredictor predictor_;
  std::array<std::vector<SymbolModel>, kFieldModels> models_;
  std::array<MixWeights<kFieldModels>, kFieldWeightSets> weights_;
  SplitNumberCoder<Coder> numbers_;
};

}  // namespace deltamesh
