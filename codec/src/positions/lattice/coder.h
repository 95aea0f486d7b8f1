// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Lattice coordinates of all vertices, in closed loop [POSN-3 .. POSN-8]. One template for both directions.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "base/small_code.h"
#include "entropy/coder/held_coder.h"
#include "positions/lattice/pair_place.h"
#include "positions/match_coder.h"
#include "positions/residual_coder.h"

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

struct LatticeModels {
  ResidualModels residuals;
  MatchModels matches;

  void limit_counts(std::uint8_t most) noexcept {
    residuals.limit_counts(most);
    matches.limit_counts(most);
  }
};

template <class Coder>
class LatticeCoder {
 public:
  /// `largest`: the most that a coordinate may be, per axis.
  /// `guesses`: coordinates are compared with guesses first [POSN-9].
  LatticeCoder(Coder& coder, const KnownFaces& faces, const std::array<std::uint32_t, 3>& largest,
               const BlendTable& blends, bool guesses, const LatticeModels* start = nullptr)
      : coder_(coder),
        faces_(faces),
        most_(four_ints({largest[0], largest[1], largest[2], 0U})),
        blends_(blends),
        history_(faces.vertex_count()),
        residuals_(coder, start != nullptr ? start->residuals : ResidualModels()) {
    if (guesses) matches_.emplace(coder, start != nullptr ? start->matches : MatchModels());
  }

  /// The models as learnt so far. Without guesses those of matches are taken from `others`.
  LatticeModels models(const LatticeModels* others) const {
    LatticeModels learnt;
    learnt.residuals = residuals_.models();
    if (matches_) {
      learnt.matches = matches_->models();
    } else if (others != nullptr) {
      learnt.matches = others->matches;
    }
    return learnt;
  }

  /// Call before the first vertex if some will not be coded, as their values are known [ATTR-59].
  void clear_history() noexcept { history_.clear(); }

  /// Codes the first `axes` coordinates, 1 to 3, of cells[vertex], those before it being coded; a reader
  /// fills them in, others are 0. False where one is beyond the largest [ATTR-57].
  bool code_vertex(std::uint32_t vertex, unsigned axes, std::span<Cell> cells) {
    Held<Coder> coder = coder_;
    Turn turn(*this, vertex, look_at(vertex, cells), cells);
    if (matches_) guess(turn, cells);
    code_axis(coder, 0, turn);
    if (axes > 1) code_axis(coder, 1, turn);
    if (axes > 2) code_axis(coder, 2, turn);
    write_back<Coder>(coder, coder_);
    if (is_beyond(turn)) return false;
    end(turn, cells);
    return true;
  }

  /// Codes cells[vertex]; all cells before it are coded. If the prediction of the next vertex does not depend
  /// on it, that one is coded as well, the axes of both alternating [POSN-13]. Advances `vertex` to the next
  /// one to code. A reader fills the cells in. Returns the rule that the stream breaks, or null.
  DELTAMESH_LOOP_BODY const char* code_next(std::uint32_t& vertex, std::span<Cell> cells) {
    if (vertex + 1 == cells.size() || faces_.needs_previous(vertex + 1)) {
      if (!code_vertex(vertex, 3, cells)) return "POSN-7";
      ++vertex;
      return nullptr;
    }
    Held<Coder> coder = coder_;
    // Start the slow part for both at once.
    const Outlook first_outlook = look_at(vertex, cells);
    const Outlook second_outlook = look_at(vertex + 1, cells);
    Turn first(*this, vertex, first_outlook, cells);
    Turn second(*this, vertex + 1, second_outlook, cells);
    if (matches_) {
      guess(first, cells);
      guess(second, cells);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      code_axis(coder, axis, first);
      code_axis(coder, axis, second);
    }
    write_back<Coder>(coder, coder_);
    if (is_beyond(first) || is_beyond(second)) return "POSN-7";
    end(first, cells);
    end(second, cells);
    vertex += 2;
    return nullptr;
  }

 private:
  /// The guesses that a vertex' coordinates are compared with.
  struct Matching {
    Matching(const Surroundings& surroundings, std::span<const Cell> cells, FourInts expected, FourInts most)
        : around(surroundings), guesses(guesses_around(surroundings, cells, expected, most)) {}
    Surroundings around;
    Guesses guesses;
    unsigned missed = 0;  ///< as MatchCoder has it
  };

  /// A vertex while it is coded.
  struct Turn {
    [[gnu::always_inline]] Turn(const LatticeCoder& coder, std::uint32_t number, const Outlook& outlook,
                                std::span<const Cell> cells)
        : vertex(number), residual(outlook, FourInts{}, coder.most_) {
      if constexpr (Coder::kWrites) cell = cells[vertex];
    }
    FourInts lanes() const noexcept { return FourInts{cell[0], cell[1], cell[2], 0}; }
    std::uint32_t vertex;
    ResidualTurn residual;
    Cell cell{};
    std::int64_t bits = 0;  ///< of all coordinates, as they were before they were cut to 32 bits
    std::optional<Matching> matching;
  };

  [[gnu::always_inline]] Outlook look_at(std::uint32_t vertex, std::span<const Cell> cells) const noexcept {
    FacePair pair;
    Outlook outlook;
    if (!faces_.pair_around(vertex, pair) || !expect_pair(pair, cells, blends_, outlook.expected))
        [[unlikely]]
      return look_around(vertex, cells);
    outlook.means = history_.mean(pair.first, pair.second);
    outlook.sources = pair.known_count + 1;
    return outlook;
  }

  [[gnu::noinline]] Outlook look_around(std::uint32_t vertex, std::span<const Cell> cells) const noexcept {
    const Surroundings around = faces_.around(vertex);
    return history_.outlook(around, expect_place(around, vertex, cells, blends_));
  }

  /// Whether a coordinate is beyond the lattice.
  [[gnu::always_inline]] bool is_beyond(const Turn& turn) const noexcept {
    return (turn.bits >> 31) != 0 || set_lanes(turn.lanes() > most_) != 0;
  }

  [[gnu::always_inline]] void end(const Turn& turn, std::span<Cell> cells) noexcept {
    const FourInts cell = turn.lanes();
    store_three(cell, cells[turn.vertex]);
    history_.end(turn.vertex, turn.residual, cell);
  }

  [[gnu::always_inline]] void code_axis(Coder& coder, std::size_t axis, Turn& turn) {
    std::int32_t& value = turn.cell[axis];
    const ResidualPrediction prediction = turn.residual.prediction(axis);
    if (!matches_ || !code_match(coder, axis, *turn.matching, value)) {
      const std::int64_t coordinate =
          prediction.whole + residuals_.code(coder, value - prediction.whole, prediction);
      turn.bits |= coordinate;
      value = static_cast<std::int32_t>(coordinate);
    }
    turn.residual.learn(axis, value, prediction);
  }

  [[gnu::noinline]] void guess(Turn& turn, std::span<const Cell> cells) const noexcept {
    turn.matching.emplace(faces_.around(turn.vertex), cells, turn.residual.nearest(), most_);
  }

  [[gnu::always_inline]] bool code_match(Coder& coder, std::size_t axis, Matching& matching,
                                         std::int32_t& value) {
    write_back<Coder>(coder, coder_);
    const bool matches = code_match(axis, matching, value);
    write_back<Coder>(coder_, coder);
    return matches;
  }
  [[gnu::noinline]] bool code_match(std::size_t axis, Matching& matching, std::int32_t& value) {
    return matches_->code(axis, matching.around, matching.guesses, value, matching.missed);
  }

  Coder& coder_;
  const KnownFaces& faces_;
  FourInts most_;  ///< of a coordinate
  BlendTable blends_;
  ResidualHistory history_;
  ResidualCoder<Coder> residuals_;
  std::optional<MatchCoder<Coder>> matches_;  ///< with guesses
};

}  // namespace deltamesh
