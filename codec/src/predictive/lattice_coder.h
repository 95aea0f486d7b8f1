// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Lattice coordinates of all vertices, in closed loop [POSN-3 .. POSN-8]. One template for both directions.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "predictive/residual_coder.h"

namespace deltamesh {

/// Rows that differ from the usual ones: a flag each, then their weights [POSN-8].
template <class Coder>
void code_blends(Coder& coder, BlendTable& table) {
  BitModel given;
  for (std::size_t row = 0; row < kBlends; ++row) {
    Blend& blend = table[row];
    const Blend& usual = kUsualBlends[row];
    if (!coder.bit(blend != usual, given)) {
      blend = usual;
      continue;
    }
    for (std::int8_t* weight : {&blend.parallelogram, &blend.edge})
      *weight = static_cast<std::int8_t>(coder.bits(static_cast<std::uint8_t>(*weight), 8));
  }
}

template <class Coder>
class LatticeCoder {
 public:
  /// `largest`: the most that a coordinate may be, per axis.
  LatticeCoder(Coder& coder, const FaceStars& stars, const std::array<std::uint32_t, 3>& largest,
               const BlendTable& blends)
      : stars_(stars),
        largest_(largest),
        blends_(blends),
        history_(stars.vertex_count()),
        residuals_(coder) {}

  /// Codes cells[vertex]; those before it are coded. A reader fills it in. False where a coordinate is out of
  /// range [POSN-7].
  bool code_vertex(std::uint32_t vertex, std::span<Cell> cells) {
    const Surroundings around = look_around(stars_, vertex);
    history_.begin(around, expect_place(around, vertex, cells, blends_));
    Cell& cell = cells[vertex];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const ResidualForecast forecast = history_.forecast(axis, 0, static_cast<std::int32_t>(largest_[axis]));
      const std::int64_t coordinate = forecast.whole + residuals_.code(cell[axis] - forecast.whole, forecast);
      if (coordinate < 0 || coordinate > largest_[axis]) return false;
      cell[axis] = static_cast<std::int32_t>(coordinate);
      history_.learn(axis, cell[axis], forecast);
    }
    history_.end(vertex);
    return true;
  }

 private:
  const FaceStars& stars_;
  std::array<std::uint32_t, 3> largest_;
  BlendTable blends_;
  ResidualHistory history_;
  ResidualCoder<Coder> residuals_;
};

}  // namespace deltamesh
