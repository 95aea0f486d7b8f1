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

#include "entropy/coder/held_coder.h"
#include "entropy/coder/split_number.h"
#include "field/field_prediction.h"
#include "topology/adjacency.h"

namespace deltamesh {

inline constexpr std::int32_t kLargestFieldValue = 1 << 30;  ///< either sign [FLD-1]

using FieldNumbers = std::array<std::int32_t, 3>;

/// `Coder` is CompactWriter, CompactReader or CompactPricer. `graph` must outlive the coder.
template <class Coder>
class FieldCoder {
 public:
  FieldCoder(Coder& coder, const Adjacency& graph) : coder_(coder), history_(graph), numbers_(coder) {
    for (std::size_t i = 0; i < models_.size(); ++i) models_[i].assign(kFieldContexts[i], kFreshSplit);
  }

  /// Codes the numbers `q` of `vertex`; all vertices before it are done. A reader fills them in. False where
  /// one is beyond kLargestFieldValue [FLD-1].
  [[gnu::always_inline]] bool code_vertex(std::uint32_t vertex, FieldNumbers& q) {
    const FieldContext around = history_.around(vertex);
    FieldPredictions predictions(around);
    Held<Coder> coder = coder_;
    const bool is_valid = code_axis<0>(coder, predictions, q) && code_axis<1>(coder, predictions, q) &&
                          code_axis<2>(coder, predictions, q);
    write_back<Coder>(coder, coder_);
    history_.remember(vertex, predictions.numbers(), around);
    return is_valid;
  }

  /// The same for a coder that tells prices: every number is `choose(axis, price)`, where price(q) is what
  /// coding q would cost in bits here and now.
  template <class Choose>
  FieldNumbers choose_vertex(std::uint32_t vertex, Choose choose) {
    const FieldContext around = history_.around(vertex);
    FieldPredictions predictions(around);
    const FieldNumbers q = {choose_axis<0>(predictions, choose), choose_axis<1>(predictions, choose),
                            choose_axis<2>(predictions, choose)};
    history_.remember(vertex, predictions.numbers(), around);
    return q;
  }

 private:
  template <unsigned kAxis>
  [[gnu::always_inline]] bool code_axis(Coder& coder, FieldPredictions& predictions, FieldNumbers& q) {
    const std::int64_t coded = code(coder, q[kAxis], predictions.template of<kAxis>(), mixes_[kAxis]);
    if (coded < -kLargestFieldValue || coded > kLargestFieldValue) return false;
    q[kAxis] = static_cast<std::int32_t>(coded);
    predictions.template settle<kAxis>(q[kAxis]);
    return true;
  }

  template <unsigned kAxis, class Choose>
  std::int32_t choose_axis(FieldPredictions& predictions, Choose& choose) {
    const FieldPrediction prediction = predictions.template of<kAxis>();
    const std::int32_t q = choose(kAxis, [&](std::int32_t candidate) {
      const auto trial = coder_.trial();
      code(coder_, candidate, prediction, mixes_[kAxis]);
      return trial.bits();
    });
    code(coder_, q, prediction, mixes_[kAxis]);
    predictions.template settle<kAxis>(q);
    return q;
  }

  /// Returns the number, of any size where the stream lies.
  [[gnu::always_inline]] std::int64_t code(Coder& coder, std::int64_t q, const FieldPrediction& f,
                                           MixWeights& weights) {
    if (f.shift > kMostLowBits) __builtin_unreachable();  // no scale is above 2^16
    const Mixture<kFieldModels> mixture{{&models_[0][f.contexts[0]], &models_[1][f.contexts[1]]}, &weights};
    const std::int64_t number = ((q - f.base) ^ f.sign) - f.sign;
    const std::int64_t result = numbers_.code(coder, number, f.shift, mixture);
    return ((result ^ f.sign) - f.sign) + f.base;
  }

  Coder& coder_;
  FieldHistory history_;
  std::array<std::vector<SymbolModel>, kFieldModels> models_;
  std::array<MixWeights, 3> mixes_;  ///< by axis
  SplitNumberCoder<Coder> numbers_;
};

}  // namespace deltamesh
