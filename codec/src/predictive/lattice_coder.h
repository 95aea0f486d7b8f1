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

  /// Codes cells[vertex], those before it being coded, and the next one's in turns with it where this can do
  /// without it [POSN-13]; `vertex` becomes what is to be coded then. A reader fills the cells in. The rule
  /// that a stream breaks here, or null.
  const char* code_next(std::uint32_t& vertex, std::span<Cell> cells) {
    Turn first(*this, vertex, cells);
    if (vertex + 1 == cells.size() || faces_.needs_previous(vertex + 1)) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (!code_axis(axis, first, cells)) return "POSN-7";
    } else {
      Turn second(*this, vertex + 1, cells);
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (!code_axis(axis, first, cells) || !code_axis(axis, second, cells)) return "POSN-7";
      end(++vertex, second, cells);
      end(vertex - 1, first, cells);
      ++vertex;
      return nullptr;
    }
    end(vertex, first, cells);
    ++vertex;
    return nullptr;
  }

 private:
  /// A vertex while it is coded.
  struct Turn {
    [[gnu::always_inline]] Turn(const LatticeCoder& coder, std::uint32_t vertex, std::span<const Cell> cells)
        : around(coder.faces_.template around<false>(vertex)),
          residual(coder.history_.begin(around, expect_place(around, vertex, cells, coder.blends_))) {
      if constexpr (Coder::kWrites) cell = cells[vertex];
    }
    Surroundings around;
    ResidualTurn residual;
    Cell cell;
    unsigned missed = 0;  ///< as MatchCoder has it
  };

  [[gnu::always_inline]] void end(std::uint32_t vertex, const Turn& turn, std::span<Cell> cells) noexcept {
    const FourInts cell = {turn.cell[0], turn.cell[1], turn.cell[2], 0};
    store_three(cell, cells[vertex]);
    history_.end(vertex, turn.residual, cell);
  }

  /// False where a coordinate is beyond the lattice.
  [[gnu::always_inline]] bool code_axis(std::size_t axis, Turn& turn, std::span<const Cell> cells) {
    std::int32_t& value = turn.cell[axis];
    const ResidualForecast forecast = turn.residual.forecast(axis, 0, largest_[axis]);
    if (!guesses_ || !matches_.code(axis, turn.around,
                                    guesses_around(turn.around, cells, axis, forecast.whole, largest_[axis]),
                                    value, turn.missed)) {
      const std::int64_t coordinate = forecast.whole + residuals_.code(value - forecast.whole, forecast);
      if (coordinate < 0 || coordinate > largest_[axis]) return false;
      value = static_cast<std::int32_t>(coordinate);
    }
    turn.residual.learn(axis, value, forecast);
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
