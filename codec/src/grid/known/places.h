// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Where a known surface cuts edges, around a brick of a newer one, and what that tells of levels [MAP-29].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "entropy/coder/counted_bit.h"
#include "entropy/coder/model.h"
#include "entropy/coder/symbol_models.h"
#include "grid/known/surface.h"
#include "grid/place_window.h"

namespace deltamesh::grid {

class KnownPlaces {
 public:
  /// By how many cuts around an edge have moved, and how many have not, 2 at most of each.
  static constexpr unsigned kMotions = 9;

  /// `surface`: null where nothing is known; `symbols`: of levels.
  KnownPlaces(const KnownSurface* surface, unsigned symbols)
      : surface_(surface), levels_(surface != nullptr ? std::size_t{symbols} * kMotions : 0) {
    for (unsigned former = 0; surface != nullptr && former < symbols; ++former)
      levels_.fill(std::size_t{former} * kMotions, kMotions, near_model(symbols, former));
  }

  /// Those around `brick`.
  void load(const Brick& brick) {
    if (surface_ == nullptr) return;
    cuts_.fill(PlaceWindow::kNoPlace);
    own_ = surface_->bricks().find(brick.at);
    for (unsigned way = 0; way < 27; ++way) {
      const Bricks::Place at = {brick.at[0] + static_cast<int>(way % 3) - 1,
                                brick.at[1] + static_cast<int>(way / 3 % 3) - 1,
                                brick.at[2] + static_cast<int>(way / 9) - 1};
      const Brick* const known = surface_->bricks().find(at);
      if (known == nullptr) continue;
      PlaceWindow::visit_cuts(*known, way, [&](unsigned slot, unsigned axis, int index) {
        cuts_[axis * PlaceWindow::kSize + static_cast<std::size_t>(index)] =
            surface_->edge(*known, slot, axis).cut;
      });
    }
  }

  /// Of an edge of the brick; null if it has no known vertex.
  const KnownEdge* find(int y, int z, unsigned x, unsigned slot, unsigned axis) const noexcept {
    const bool is_known = own_ != nullptr &&
                          (own_->cut[static_cast<std::size_t>(y + kSide * z)] & Brick::cut_bit(x, axis)) != 0;
    return is_known ? &surface_->edge(*own_, slot, axis) : nullptr;
  }

  /// Around the edge at `index` of `window`; below kMotions.
  unsigned motion(const PlaceWindow& window, int index, unsigned axis) const noexcept {
    unsigned moved = 0;
    unsigned still = 0;
    const auto look = [&](unsigned k, int at) {
      const std::int8_t now = window.places(k)[at];
      const std::int8_t before = cuts_[k * PlaceWindow::kSize + static_cast<std::size_t>(at)];
      if (now != PlaceWindow::kNoPlace && before != PlaceWindow::kNoPlace) ++(now == before ? still : moved);
    };
    for (const unsigned k : {(axis + 1) % 3, (axis + 2) % 3}) {
      const int step = PlaceWindow::kStep[k];
      for (const int at : {index - step, index + step}) look(axis, at);
      for (const int at : {index, index + PlaceWindow::kStep[axis]}) {
        look(k, at - step);
        look(k, at);
      }
    }
    return 3 * std::min(moved, 2U) + std::min(still, 2U);
  }

  SymbolModel& level_model(unsigned former, unsigned motion) noexcept {
    return levels_[std::size_t{former} * kMotions + motion];
  }
  MixWeights& weights(unsigned motion) noexcept { return weights_[motion]; }
  /// Whether a level is the former one, where both have the same symbol.
  CountedBit& is_same(unsigned motion) noexcept { return is_same_[motion]; }

 private:
  /// Most likely `former`.
  static SymbolModel near_model(unsigned symbols, unsigned former) noexcept {
    std::array<std::uint8_t, kSymbols> weights{};
    for (unsigned s = 0; s < kSymbols; ++s) {
      const unsigned way = s > former ? s - former : former - s;
      weights[s] = static_cast<std::uint8_t>(s >= symbols ? 0 : way < 3 ? 32 >> 2 * way : 1);
    }
    return SymbolModel(weights);
  }

  const KnownSurface* surface_;
  SymbolModels levels_;
  std::array<MixWeights, kMotions> weights_;
  std::array<CountedBit, kMotions> is_same_;
  const Brick* own_ = nullptr;
  std::array<std::int8_t, 3 * PlaceWindow::kSize> cuts_;  ///< as in PlaceWindow
};

}  // namespace deltamesh::grid
