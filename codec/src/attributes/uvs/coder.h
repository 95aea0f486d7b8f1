// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Texture coordinates vertex by vertex: equal to a copy's, or a prediction and what it is off by, in steps
// [ATTR-36, ATTR-37]. One template for both directions.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "attributes/equal_copies.h"
#include "attributes/prediction/pair_coder.h"
#include "attributes/surface.h"
#include "attributes/surface_order.h"
#include "attributes/uvs/prediction.h"
#include "base/memory/large_vector.h"
#include "base/numbers/portable_math.h"
#include "base/small_code.h"

namespace deltamesh {

/// Steps of a stream [ATTR-31].
inline constexpr float kLeastUvStep = 0x1p-100F;
inline constexpr float kMostUvStep = 0x1p64F;
/// Predictions are cut to this many steps, either sign.
inline constexpr double kMostUvSteps = 0x1p22;

/// Codes texture coordinates in both directions. `Numbers` makes a writer's decisions:
/// bool is_within(std::uint32_t vertex, TwoDoubles value): whether the value is within the bound;
/// NumberPair nearest(std::uint32_t vertex, TwoDoubles prediction): the steps to code.
template <class Coder, class Numbers>
class UvCoder {
 public:
  UvCoder(Coder& coder, const AttributeSurface& surface, double step, Numbers numbers)
      : step_(step),
        choice_(numbers),
        order_(surface.surface_order()),
        predictor_(surface, order_),
        pairs_(coder),
        copies_(coder, surface),
        sizes_(surface.vertex_count()),
        values_(std::size_t{2} * surface.vertex_count()) {}

  std::size_t count() const noexcept { return order_.vertices.size(); }

  /// Codes the vertex that is number i of the surface order. False where a number is out of range.
  DELTAMESH_LOOP_BODY bool code(std::size_t i) {
    const std::uint32_t vertex = order_.vertices[i];
    const UvPrediction prediction = predictor_.prediction(i);
    const std::uint32_t copy = copies_.last(vertex);
    const bool has_copy = copy != EqualCopies<Coder>::kNone;
    bool is_equal = false;
    if constexpr (Coder::kWrites) is_equal = has_copy && choice_.is_within(vertex, predictor_.value(copy));
    TwoDoubles value{};
    if (has_copy && copies_.code(i, is_equal)) {
      value = predictor_.value(copy);
    } else {
      NumberPair pair{};
      const TwoDoubles place = cut(prediction.place);
      if constexpr (Coder::kWrites) pair = choice_.nearest(vertex, place);
      if (!code_pair(i, vertex, prediction, pair)) return false;
      value = at(place, pair, step_);
    }
    values_[std::size_t{2} * vertex] = static_cast<float>(value[0]);
    values_[std::size_t{2} * vertex + 1] = static_cast<float>(value[1]);
    predictor_.settle(i, value);
    return true;
  }

  std::vector<float>& values() noexcept { return values_; }

  /// `pair` steps from `place`, rounded to floats.
  static TwoDoubles at(TwoDoubles place, const NumberPair& pair, double step) noexcept {
    return TwoDoubles{static_cast<double>(rounded(place[0] + step * static_cast<double>(pair[0]))),
                      static_cast<double>(rounded(place[1] + step * static_cast<double>(pair[1])))};
  }

 private:
  static constexpr double kMostSize = 0x1p17;  ///< 1/16 steps

  /// Predictions far off are cut; what is not a number becomes 0.
  TwoDoubles cut(TwoDoubles place) const noexcept {
    const double most = kMostUvSteps * step_;
    for (std::size_t k = 0; k < 2; ++k)
      place[k] = place[k] == place[k] ? std::clamp(place[k], -most, most) : 0;
    return place;
  }

  bool code_pair(std::size_t i, std::uint32_t vertex, const UvPrediction& prediction, NumberPair& pair) {
    PairContext context;
    if (prediction.is_start) {
      context = {.near = {kFresh, kFresh}, .spread = {kFresh, kFresh}, .kind = prediction.sources};
    } else {
      std::uint64_t sum = 0;
      std::uint32_t count = 0;
      order_.for_corners_before(i, [&](std::uint32_t before) {
        sum += sizes_[before];
        ++count;
      });
      const double steps = prediction.spread * (kPairUnit / step_);
      const auto spread = static_cast<std::uint32_t>(steps < kMostSize ? steps : kMostSize);
      const std::uint32_t near = count != 0 ? static_cast<std::uint32_t>(sum / count) : 0;
      context = {.near = {near, near}, .spread = {spread, spread}, .kind = 1 + prediction.sources};
    }
    if (!pairs_.code(pair, context)) return false;
    if (prediction.is_start) return true;
    const auto size = [](std::int32_t x) { return static_cast<std::uint32_t>(x < 0 ? -x : x); };
    const std::uint32_t mean = std::min(kPairUnit / 2 * (size(pair[0]) + size(pair[1])), kMostNear);
    sizes_[vertex] = (5 * mean + 3 * context.near[0]) >> 3;
    return true;
  }

  static constexpr std::uint32_t kFresh = 4096;
  static constexpr std::uint32_t kMostNear = 1U << 17;

  double step_;
  Numbers choice_;
  const SurfaceOrder& order_;
  UvPredictor predictor_;
  PairCoder<Coder> pairs_;
  EqualCopies<Coder> copies_;
  std::vector<std::uint32_t> sizes_;  ///< of the pair, smoothed, 1/16 steps
  std::vector<float> values_;         ///< n x 2
};

}  // namespace deltamesh
