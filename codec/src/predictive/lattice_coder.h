// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Lattice coordinates of all vertices, in closed loop [POSN-3 .. POSN-8]. One template for both directions.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "predictive/match_coder.h"
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
  /// `guesses`: coordinates are compared with guesses first [POSN-9].
  LatticeCoder(Coder& coder, const KnownFaces& faces, const std::array<std::uint32_t, 3>& largest,
               const BlendTable& blends, bool guesses)
      : faces_(faces),
        largest_(largest),
        blends_(blends),
        history_(faces.vertex_count()),
        residuals_(coder),
        matches_(coder),
        guesses_(guesses) {}

  /// Codes cells[vertex]; those before it are coded. A reader fills it in. The rule that a stream breaks
  /// here, or null.
  const char* code_vertex(std::uint32_t vertex, std::span<Cell> cells) {
    const Surroundings around = faces_.around(vertex);
    history_.begin(around, expect_place(around, vertex, cells, blends_));
    Cell& cell = cells[vertex];
    matches_.begin();
    if (!code_axis<0>(around, cells, cell) || !code_axis<1>(around, cells, cell) ||
        !code_axis<2>(around, cells, cell))
      return "POSN-7";
    history_.end(vertex, cell);
    return nullptr;
  }

 private:
  /// False where a coordinate is beyond the lattice.
  template <std::size_t kAxis>
  [[gnu::always_inline]] bool code_axis(const Surroundings& around, std::span<const Cell> cells, Cell& cell) {
    const ResidualForecast forecast = history_.template forecast<kAxis>(0, largest_[kAxis]);
    if (!guesses_ ||
        !matches_.code(kAxis, around, guesses_around(around, cells, kAxis, forecast.whole, largest_[kAxis]),
                       cell[kAxis])) {
      const std::int64_t coordinate =
          forecast.whole + residuals_.code(cell[kAxis] - forecast.whole, forecast);
      if (coordinate < 0 || coordinate > largest_[kAxis]) return false;
      cell[kAxis] = static_cast<std::int32_t>(coordinate);
    }
    history_.template learn<kAxis>(cell[kAxis], forecast);
    return true;
  }

  const KnownFaces& faces_;
  std::array<std::uint32_t, 3> largest_;
  BlendTable blends_;
  ResidualHistory history_;
  ResidualCoder<Coder> residuals_;
  MatchCoder<Coder> matches_;
  bool guesses_;
};

}  // namespace deltamesh
