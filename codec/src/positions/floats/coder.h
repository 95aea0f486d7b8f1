// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Positions to the last bit: floats as ordered integers, equal to a neighbour's or apart from a predicted one
// [FLT-*]. One template for both directions.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "base/memory/large_vector.h"
#include "positions/floats/order.h"
#include "positions/match_coder.h"
#include "positions/residual_coder.h"

namespace deltamesh {

/// The floats of a vertex as ordinals.
using Ordinals = std::array<std::int32_t, 3>;

template <class Coder>
class FloatCoder {
 public:
  /// `units`: unit_exponent() of every axis.
  FloatCoder(Coder& coder, const KnownFaces& faces, const std::array<int, 3>& units, const BlendTable& blends)
      : faces_(faces),
        units_(units),
        blends_(blends),
        history_(faces.vertex_count()),
        residuals_(coder),
        matches_(coder),
        cells_(faces.vertex_count(), Cell{}) {}

  /// Codes floats[vertex]; those before it are coded. A reader fills it in. The rule that a stream breaks
  /// here, or null.
  const char* code_vertex(std::uint32_t vertex, std::span<Ordinals> floats) {
    const Surroundings around = faces_.around(vertex);
    const FourInts most = FourInts{} + kLargestFixed;
    ResidualTurn turn(history_.outlook(around, expect_place(around, vertex, cells_, blends_)), -most, most);
    const FourInts expected = ordinals_of(turn.nearest());
    const Guesses guesses = guess(around, floats, expected);
    unsigned missed = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (!code_axis(axis, expected[static_cast<int>(axis)], around, guesses, turn, missed,
                     floats[vertex][axis]))
        return "FLT-1";
    Cell& cell = cells_[vertex];
    for (std::size_t axis = 0; axis < 3; ++axis) cell[axis] = fixed_of(floats[vertex][axis], units_[axis]);
    history_.end(vertex, turn, four_ints(cell));
    return nullptr;
  }

 private:
  /// False where a float is not finite.
  bool code_axis(std::size_t axis, std::int32_t expected, const Surroundings& around, const Guesses& guesses,
                 ResidualTurn& turn, unsigned& missed, std::int32_t& value) {
    const ResidualPrediction prediction = turn.prediction(axis);
    if (!matches_.code(axis, around, guesses, value, missed)) {
      const std::int64_t coded =
          expected + residuals_.code(std::int64_t{value} - expected, fit(prediction, expected, axis));
      if (!is_finite_ordinal(coded)) return false;
      value = static_cast<std::int32_t>(coded);
    }
    turn.learn(axis, fixed_of(value, units_[axis]), prediction);
    return true;
  }

  FourInts ordinals_of(FourInts fixed) const noexcept {
    FourInts result{};
    for (int axis = 0; axis < 3; ++axis)
      result[axis] = ordinal_of_fixed(fixed[axis], units_[static_cast<std::size_t>(axis)]);
    return result;
  }

  /// The floats of the known faces' corners [FLT-4].
  static Guesses guess(const Surroundings& around, std::span<const Ordinals> floats,
                       FourInts expected) noexcept {
    Guesses guesses(expected);
    const FourInts always = ~FourInts{};
    for (unsigned i = 0; i < around.known_count; ++i) {
      guesses.add(four_ints(floats[around.known[i].a]), always);
      guesses.add(four_ints(floats[around.known[i].b]), always);
    }
    return guesses;
  }

  /// The prediction in last places of the expected float, not in units.
  ResidualPrediction fit(ResidualPrediction prediction, std::int32_t expected, std::size_t axis) const {
    const auto size = static_cast<std::uint32_t>(expected >= 0 ? expected : -1 - expected);
    const int shift = prediction.scale_bits - 6 + units_[axis] - last_place(size);
    prediction.shift = static_cast<unsigned>(std::clamp(shift, 0, 24));
    return prediction;
  }

  const KnownFaces& faces_;
  std::array<int, 3> units_;
  BlendTable blends_;
  ResidualHistory history_;
  ResidualCoder<Coder> residuals_;
  MatchCoder<Coder> matches_;
  LargeVector<Cell> cells_;  ///< in units
};

}  // namespace deltamesh
