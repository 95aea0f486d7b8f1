// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Positions to the last bit: floats as ordered integers, equal to a neighbour's or apart from a predicted one
// [FLT-*]. One template for both directions.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "predictive/float_order.h"
#include "predictive/residual_coder.h"

namespace deltamesh {

/// The floats of a vertex as ordinals.
using Ordinals = std::array<std::int32_t, 3>;

template <class Coder>
class FloatCoder {
 public:
  /// `units`: unit_exponent() of every axis.
  FloatCoder(Coder& coder, const FaceStars& stars, const std::array<int, 3>& units, const BlendTable& blends)
      : coder_(coder),
        stars_(stars),
        units_(units),
        blends_(blends),
        history_(stars.vertex_count()),
        residuals_(coder),
        cells_(stars.vertex_count()) {
    for (std::size_t i = 0; i < matches_.size(); ++i) matches_[i].assign(kMatchContexts[i], kFreshMatch);
  }

  /// Codes floats[vertex]; those before it are coded. A reader fills it in. False where one is not finite
  /// [FLT-1].
  bool code_vertex(std::uint32_t vertex, std::span<Ordinals> floats) {
    const Surroundings around = look_around(stars_, vertex);
    history_.begin(around, expect_place(around, vertex, cells_, blends_));
    Cell& cell = cells_[vertex];
    unsigned missed = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const ResidualForecast forecast = history_.forecast(axis, -kLargestFixed, kLargestFixed);
      const std::int32_t expected = ordinal_of_fixed(static_cast<std::int32_t>(forecast.whole), units_[axis]);
      std::int32_t& value = floats[vertex][axis];
      if (!code_match(around, floats, axis, expected, missed, value)) {
        const std::int64_t coded =
            expected + residuals_.code(std::int64_t{value} - expected, fit(forecast, expected, axis));
        if (!is_finite_ordinal(coded)) return false;
        value = static_cast<std::int32_t>(coded);
        missed |= 1U << axis;
      }
      cell[axis] = fixed_of(value, units_[axis]);
      history_.learn(axis, cell[axis], forecast);
    }
    history_.end(vertex);
    return true;
  }

 private:
  static constexpr unsigned kMostValues = 6;
  static constexpr std::array<std::uint32_t, 2> kMatchContexts = {3 * 4 * 7, 5 * 7 * 7};
  static constexpr SymbolModel kFreshMatch{{8, 4, 2, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}};

  /// Different floats of the neighbours, nearest to `expected` first.
  struct Values {
    std::array<std::int32_t, kMostValues> value;
    unsigned count = 0;
  };
  static Values neighbor_values(const Surroundings& around, std::span<const Ordinals> floats,
                                std::size_t axis, std::int32_t expected) {
    const auto off = [expected](std::int32_t x) { return std::llabs(std::int64_t{x} - expected); };
    Values values;
    for (unsigned i = 0; i < around.neighbor_count && values.count < kMostValues; ++i) {
      const std::int32_t value = floats[around.neighbors[i]][axis];
      const auto end = values.value.begin() + values.count;
      if (std::find(values.value.begin(), end, value) != end) continue;
      unsigned place = values.count++;
      for (; place > 0 && off(values.value[place - 1]) > off(value); --place)
        values.value[place] = values.value[place - 1];
      values.value[place] = value;
    }
    return values;
  }

  /// Whether the float is one of the neighbours', and which: symbol 0 says none [FLT-4].
  bool code_match(const Surroundings& around, std::span<const Ordinals> floats, std::size_t axis,
                  std::int32_t expected, unsigned missed, std::int32_t& value) {
    const Values values = neighbor_values(around, floats, axis, expected);
    if (values.count == 0) return false;
    const auto end = values.value.begin() + values.count;
    const auto found = std::find(values.value.begin(), end, value);
    const unsigned wanted = found == end ? 0 : static_cast<unsigned>(found - values.value.begin()) + 1;
    const auto a = static_cast<unsigned>(axis);
    const unsigned sources = std::min(around.parallelogram_count, 4U);
    const unsigned before = a == 0 ? 0 : a == 1 ? 1 + (missed & 1U) : 3 + (missed & 3U);
    const unsigned symbol = coder_.symbol(
        wanted, Mixture<2>{{&matches_[0][(a * 4 + (missed & 3U)) * 7 + values.count],
                            &matches_[1][(sources * 7 + before) * 7 + std::min(around.faces, 6U)]},
                           &match_weights_});
    if (symbol == 0 || symbol > values.count) return false;
    value = values.value[symbol - 1];
    return true;
  }

  /// The forecast in last places of the expected float, not in units.
  ResidualForecast fit(ResidualForecast forecast, std::int32_t expected, std::size_t axis) const {
    const auto size = static_cast<std::uint32_t>(expected >= 0 ? expected : -1 - expected);
    const int shift = forecast.scale_bits - 6 + units_[axis] - last_place(size);
    forecast.shift = static_cast<unsigned>(std::clamp(shift, 0, 24));
    return forecast;
  }

  Coder& coder_;
  const FaceStars& stars_;
  std::array<int, 3> units_;
  BlendTable blends_;
  ResidualHistory history_;
  ResidualCoder<Coder> residuals_;
  std::vector<Cell> cells_;  ///< in units
  std::array<std::vector<SymbolModel>, 2> matches_;
  MixWeights<2> match_weights_;
};

}  // namespace deltamesh
