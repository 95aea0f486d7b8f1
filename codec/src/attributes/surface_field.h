// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Up to three whole numbers at every vertex, predicted from the faces around as positions are [ATTR-57]. One
// template for both directions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "predictive/guesses.h"
#include "predictive/match_coder.h"
#include "predictive/residual_coder.h"

namespace deltamesh {

/// How a field is coded.
struct SurfaceFieldShape {
  unsigned axes = 3;                    ///< 1 to 3; the other numbers are 0
  std::array<std::uint32_t, 3> most{};  ///< numbers are 0 to this, which is at most 2^28
  BlendTable blends = kUsualBlends;
  bool guesses = false;  ///< numbers are compared with those around first
  bool sparse = false;   ///< what is at rest is told in runs [ATTR-59]
  Cell rest{};           ///< the numbers there
};

template <class Coder>
class SurfaceFieldCoder {
 public:
  SurfaceFieldCoder(Coder& coder, const KnownFaces& faces, const SurfaceFieldShape& shape)
      : faces_(faces),
        shape_(shape),
        most_(four_ints({shape.most[0], shape.most[1], shape.most[2], 0U})),
        history_(faces.vertex_count()),
        residuals_(coder) {
    if (shape.sparse) history_.clear();
    if (shape.guesses) matches_.emplace(coder);
  }

  /// Codes cells[vertex], those before it being coded; a reader fills it in. False where a number is beyond
  /// the most it may be.
  bool code_vertex(std::uint32_t vertex, std::span<Cell> cells) {
    const Surroundings around = faces_.around(vertex);
    ResidualTurn turn(history_.outlook(around, expect_place(around, vertex, cells, shape_.blends)),
                      FourInts{}, most_);
    const Guesses guesses =
        shape_.guesses ? guesses_around(around, cells, turn.nearest(), most_) : Guesses(turn.nearest());
    unsigned missed = 0;
    for (std::size_t axis = 0; axis < shape_.axes; ++axis) {
      std::int32_t& value = cells[vertex][axis];
      const ResidualForecast forecast = turn.forecast(axis);
      if (!matches_ || !matches_->code(axis, around, guesses, value, missed)) {
        const std::int64_t coded =
            forecast.whole + residuals_.code(std::int64_t{value} - forecast.whole, forecast);
        if (coded < 0 || coded > std::int64_t{shape_.most[axis]}) return false;
        value = static_cast<std::int32_t>(coded);
      }
      turn.learn(axis, value, forecast);
    }
    history_.end(vertex, turn, four_ints(cells[vertex]));
    return true;
  }

 private:
  const KnownFaces& faces_;
  SurfaceFieldShape shape_;
  FourInts most_;
  ResidualHistory history_;
  ResidualCoder<Coder> residuals_;
  std::optional<MatchCoder<Coder>> matches_;  ///< with guesses
};

}  // namespace deltamesh
