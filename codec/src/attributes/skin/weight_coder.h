// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The weights of a vertex' joints, whole numbers with the same sum everywhere, from what the vertices around
// give the same joints [ATTR-64, ATTR-65]. One template for both directions.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "attributes/skin/joint_coder.h"
#include "positions/guesses.h"
#include "positions/match_coder.h"
#include "positions/residual_coder.h"

namespace deltamesh {

/// Weights of a vertex' joints, 0 or above.
using WeightRow = std::array<std::int32_t, kInfluences>;

/// Of parallelograms alone, a little less than the whole.
inline BlendTable weight_blends() noexcept {
  BlendTable table;
  table.fill({.parallelogram = 60, .edge = 0});
  return table;
}

template <class Coder>
class WeightCoder {
 public:
  /// `joints`: of every vertex of `faces`; `sum`: of every vertex' weights, at least 1.
  WeightCoder(Coder& coder, const KnownFaces& faces, std::span<const JointRow> joints, std::int32_t sum)
      : coder_(coder),
        faces_(faces),
        joints_(joints),
        sum_(sum),
        blends_(weight_blends()),
        history_(faces.vertex_count()),
        residuals_(coder),
        matches_(coder) {}

  /// Codes weights[vertex], those before it being coded; a reader fills it in. False where a weight is
  /// beyond what the others leave.
  bool code_vertex(std::uint32_t vertex, std::span<WeightRow> weights) {
    const Near near = look(vertex, weights);
    ResidualTurn turn(history_.outlook(near.around, expect(near)), FourInts{}, FourInts{} + sum_);
    const Guesses guesses = guess(near, turn.nearest());
    unsigned missed = 0;
    WeightRow& row = weights[vertex];
    std::int32_t rest = sum_;
    unsigned kinds = 0;  // of the slots before
    for (std::size_t slot = 0; slot + 1 < kInfluences; ++slot) {
      ResidualPrediction prediction = turn.prediction(slot);
      if (rest == 0) {
        row[slot] = 0;
      } else {
        const unsigned kind = code_kind(near, vertex, slot, prediction.whole, row[slot], rest, kinds);
        kinds = 3 * (kinds % 3) + kind;
        if (kind != kBetween) {
          row[slot] = kind == kZero ? 0 : rest;
        } else {
          if (rest < 2) return false;
          prediction.whole = std::clamp<std::int64_t>(prediction.whole, 1, rest - 1);
          std::int32_t& value = row[slot];
          if (!matches_.code(slot, near.around, guesses, value, missed)) {
            const std::int64_t coded =
                prediction.whole + residuals_.code(std::int64_t{value} - prediction.whole, prediction);
            if (coded < 1 || coded >= rest) return false;
            value = static_cast<std::int32_t>(coded);
          }
          if (value >= rest) return false;
        }
      }
      turn.learn(slot, row[slot], prediction);
      rest -= row[slot];
    }
    row[kInfluences - 1] = rest;
    history_.end(vertex, turn, FourInts{row[0], row[1], row[2], 0});
    return true;
  }

 private:
  enum Kind : unsigned { kZero = 0, kRest = 1, kBetween = 2 };
  static constexpr SymbolModel kFreshKind{{10, 6, 10, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}};

  /// The weights that the corners of known faces have for a vertex' first three joints.
  struct Near {
    Surroundings around;
    std::array<Cell, std::size_t{3} * Surroundings::kMostKnown> cells{};  ///< of a, b and opposite in turn
  };

  Cell of_joints(std::uint32_t vertex, const JointRow& wanted,
                 std::span<const WeightRow> weights) const noexcept {
    const auto lanes = std::bit_cast<FourInts>(wanted);
    FourInts sum{};
    for (std::size_t slot = 0; slot < kInfluences; ++slot)
      sum += (lanes == joints_[vertex][slot]) & weights[vertex][slot];
    Cell cell;
    store_three(sum, cell);
    return cell;
  }

  Near look(std::uint32_t vertex, std::span<const WeightRow> weights) const noexcept {
    Near near{.around = faces_.around(vertex)};
    const JointRow& wanted = joints_[vertex];
    if (near.around.known_count == 0 && vertex > 0) near.cells[0] = of_joints(vertex - 1, wanted, weights);
    for (unsigned i = 0; i < near.around.known_count; ++i) {
      const KnownFace& face = near.around.known[i];
      near.cells[3 * i] = of_joints(face.a, wanted, weights);
      near.cells[3 * i + 1] = of_joints(face.b, wanted, weights);
      if (face.opposite != kNoVertex) near.cells[3 * i + 2] = of_joints(face.opposite, wanted, weights);
    }
    return near;
  }

  /// From near.cells alone.
  Expectation expect(const Near& near) const noexcept {
    Surroundings local = near.around;
    for (unsigned i = 0; i < local.known_count; ++i)
      local.known[i] = {3 * i, 3 * i + 1, local.known[i].opposite == kNoVertex ? kNoVertex : 3 * i + 2};
    return expect_place(local, 1, near.cells, blends_);
  }

  Guesses guess(const Near& near, FourInts expected) const noexcept {
    Guesses guesses(expected);
    for (unsigned i = 0; i < near.around.known_count; ++i) {
      for (unsigned k = 0; k < (near.around.known[i].opposite == kNoVertex ? 2U : 3U); ++k) {
        const FourInts cell = four_ints(near.cells[3 * i + k]);
        guesses.add(cell, (cell > 0) & (cell < sum_));
      }
    }
    return guesses;
  }

  unsigned code_kind(const Near& near, std::uint32_t vertex, std::size_t slot, std::int64_t expected,
                     std::int32_t weight, std::int32_t rest, unsigned kinds) {
    unsigned none = 0;  // corners that give the joint nothing
    for (unsigned i = 0; i < near.around.known_count; ++i)
      for (unsigned k = 0; k < 2; ++k) none += near.cells[3 * i + k][slot] == 0 ? 1 : 0;
    const unsigned corners = 2 * near.around.known_count;
    const unsigned empty = corners == 0          ? 4
                           : none == 0           ? 0
                           : none == corners     ? 3
                           : 2 * none <= corners ? 1
                                                 : 2;
    const unsigned left = expected >= rest ? 0 : share(rest - expected);
    const JointRow& row = joints_[vertex];
    const bool repeated = std::find(row.begin(), row.begin() + slot, row[slot]) != row.begin() + slot;
    const auto s = static_cast<unsigned>(slot);
    const unsigned first = ((s * 5 + empty) * 5 + left) * 2 + (repeated ? 1 : 0);
    const unsigned second = (s * 9 + kinds) * 6 + std::min(share(expected) + (expected > 0 ? 1 : 0), 5U);
    const unsigned kind = weight == 0 ? kZero : weight == rest ? kRest : kBetween;
    const unsigned coded = coder_.symbol(kind, Mixture<2>{{&models_[0][first], &models_[1][second]}, &mix_});
    return std::min<unsigned>(coded, kBetween);
  }

  /// How much of the sum a number is, in classes 0 to 4.
  unsigned share(std::int64_t number) const noexcept {
    const std::int64_t n = std::max<std::int64_t>(number, 0);
    return 1U + (64 * n > sum_ ? 1U : 0U) + (16 * n > sum_ ? 1U : 0U) + (4 * n > sum_ ? 1U : 0U);
  }

  Coder& coder_;
  const KnownFaces& faces_;
  std::span<const JointRow> joints_;
  std::int32_t sum_;
  BlendTable blends_;
  ResidualHistory history_;
  ResidualCoder<Coder> residuals_;
  MatchCoder<Coder> matches_;
  std::array<SymbolModels, 2> models_{SymbolModels(3 * 5 * 5 * 2, kFreshKind),
                                      SymbolModels(3 * 9 * 6, kFreshKind)};
  MixWeights mix_;
};

}  // namespace deltamesh
