// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Tangents vertex by vertex: equal to a copy's, or a sign, a prediction and what it is off by [ATTR-42 to
// ATTR-44]. One template for both directions.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "attributes/equal_copies.h"
#include "attributes/prediction/pair_coder.h"
#include "attributes/surface.h"
#include "attributes/surface_order.h"
#include "attributes/tangents/prediction.h"
#include "base/small_code.h"

namespace deltamesh {

/// Steps of a stream, in the stereographic plane [ATTR-38].
inline constexpr float kLeastTangentStep = 0x1p-20F;
inline constexpr float kMostTangentStep = 1;

using Tangent = std::array<float, 4>;

/// Codes tangents in both directions. `Choice` makes a writer's decisions:
/// bool will_do(std::uint32_t vertex, const Tangent& tangent): whether it is near enough and has the same
/// sign; bool is_negative(std::uint32_t vertex): the sign; NumberPair nearest(std::uint32_t vertex, const
/// NormalFrame& frame, PlanePoint center): the steps to code.
template <class Coder, class Choice>
class TangentCoder {
 public:
  TangentCoder(Coder& coder, const AttributeSurface& surface, std::span<const float> normals,
               std::span<const float> uvs, float step, Choice choice)
      : coder_(coder),
        step_(step),
        choice_(choice),
        order_(surface.surface_order()),
        predictor_(surface, order_, normals, uvs),
        pairs_(coder),
        copies_(coder, surface),
        sizes_(surface.vertex_count()),
        against_(surface.vertex_count()),
        values_(std::size_t{4} * surface.vertex_count()) {}

  std::size_t count() const noexcept { return order_.vertices.size(); }

  /// Codes the vertex that is number i of the surface order. False where a number is out of range.
  DELTAMESH_LOOP_BODY bool code(std::size_t i) {
    const std::uint32_t vertex = order_.vertices[i];
    const TangentPrediction prediction = predictor_.prediction(i);
    const std::uint32_t copy = copies_.last(vertex);
    const bool has_copy = copy != EqualCopies<Coder>::kNone;
    bool is_equal = false;
    if constexpr (Coder::kWrites) is_equal = has_copy && choice_.will_do(vertex, value(copy));
    Tangent tangent{};
    if (has_copy && copies_.code(i, is_equal)) {
      tangent = value(copy);
    } else {
      NumberPair pair{};
      const bool is_negative = code_sign(i, vertex, prediction);
      if constexpr (Coder::kWrites) pair = choice_.nearest(vertex, prediction.frame, prediction.center);
      if (!code_pair(i, vertex, prediction, pair)) return false;
      if (!tangent_at(prediction.frame, prediction.center, pair, step_, tangent)) return false;
      tangent[3] = is_negative ? -1 : 1;
    }
    std::copy(tangent.begin(), tangent.end(), values_.begin() + std::ptrdiff_t{4} * vertex);
    predictor_.settle(i, FourFloats{tangent[0], tangent[1], tangent[2], 0});
    return true;
  }

  std::vector<float>& values() noexcept { return values_; }

  /// Computes the tangent that lies `pair` steps from `center`; leaves its sign as it is. False if that is
  /// outside the plane's range.
  static bool tangent_at(const NormalFrame& frame, PlanePoint center, const NumberPair& pair, float step,
                         Tangent& tangent) noexcept {
    FourFloats direction{};
    const PlanePoint place = {center[0] + step * static_cast<float>(pair[0]),
                              center[1] + step * static_cast<float>(pair[1])};
    if (!direction_at(frame, place, direction)) return false;
    for (std::size_t k = 0; k < 3; ++k) tangent[k] = direction[k];
    return true;
  }

 private:
  static constexpr std::uint32_t kFresh = 4096;
  static constexpr std::uint32_t kMostNear = 1U << 17;

  Tangent value(std::uint32_t vertex) const noexcept {
    Tangent tangent{};
    std::copy_n(values_.begin() + std::ptrdiff_t{4} * vertex, 4, tangent.begin());
    return tangent;
  }

  /// Codes whether the sign agrees with the texture's orientation; the context is whether it did at the
  /// corners before.
  bool code_sign(std::size_t i, std::uint32_t vertex, const TangentPrediction& prediction) {
    unsigned context = 0;
    order_.for_corners_before(i, [&](std::uint32_t before) { context |= against_[before]; });
    bool is_against = false;
    if constexpr (Coder::kWrites) is_against = choice_.is_negative(vertex) == prediction.is_mirrored;
    is_against = coder_.bit(is_against, sign_models_[context]);
    against_[vertex] = is_against ? 2 : 1;
    return is_against == prediction.is_mirrored;
  }

  bool code_pair(std::size_t i, std::uint32_t vertex, const TangentPrediction& prediction, NumberPair& pair) {
    PairContext context{.kind = static_cast<std::uint32_t>(prediction.source)};
    std::array<std::uint64_t, 2> sum{};
    std::uint32_t count = 0;
    order_.for_corners_before(i, [&](std::uint32_t before) {
      for (std::size_t k = 0; k < 2; ++k) sum[k] += sizes_[before][k];
      ++count;
    });
    for (std::size_t k = 0; k < 2; ++k) {
      const float spread = prediction.spread[k] * (kPairUnit / step_);
      context.near[k] = count != 0 ? static_cast<std::uint32_t>(sum[k] / count) : kFresh;
      context.spread[k] = static_cast<std::uint32_t>(
          spread < static_cast<float>(kMostNear) ? spread : static_cast<float>(kMostNear));
    }
    if (!pairs_.code(pair, context)) return false;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto size = static_cast<std::uint32_t>(pair[k] < 0 ? -pair[k] : pair[k]);
      sizes_[vertex][k] = (5 * std::min(kPairUnit * size, kMostNear) + 3 * context.near[k]) >> 3;
    }
    return true;
  }

  Coder& coder_;
  float step_;
  Choice choice_;
  const SurfaceOrder& order_;
  TangentPredictor predictor_;
  PairCoder<Coder> pairs_;
  EqualCopies<Coder> copies_;
  std::array<BitModel, 4> sign_models_;
  std::vector<std::array<std::uint32_t, 2>> sizes_;  ///< of the numbers, smoothed, 1/16 steps
  std::vector<std::uint8_t> against_;                ///< 0 where no sign was coded
  std::vector<float> values_;                        ///< n x 4
};

}  // namespace deltamesh
