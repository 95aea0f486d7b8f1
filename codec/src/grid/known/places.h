// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Where a known surface cuts edges, around a brick of a newer one, and what that tells of levels [MAP-29].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "entropy/coder/counted_bit.h"
#include "grid/known/surface.h"
#include "grid/place_window.h"

namespace deltamesh::grid {

/// What the cuts around an edge have done since the known surface.
struct Motion {
  unsigned still;  ///< how many are where they were, 2 at most
  unsigned moved;  ///< 0: none has; else 1, and 1 more if they went far, 2 more if they are several
  unsigned way;    ///< those of the edges beside, along the axis: 0 down, 1 nowhere, 2 up

  /// 0: none has moved; 1: not far; 2: far.
  unsigned far() const noexcept { return moved == 0 ? 0 : 2 - moved % 2; }
};

class KnownPlaces {
 public:
  /// `surface`: null where nothing is known; `symbols`: how many levels have [GRD-10].
  KnownPlaces(const KnownSurface* surface, unsigned symbols) noexcept
      : surface_(surface), symbols_(static_cast<int>(symbols)) {
    for (std::size_t i = 0; i < is_same_.size(); ++i) {
      is_same_[i] = CountedBit(static_cast<std::uint16_t>((5 + i % 3 - i / 3) << 13));
      is_above_[i] = CountedBit(static_cast<std::uint16_t>((1 + i % 3 + i / 3) << 13));
    }
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

  /// Around the edge at `index` of `window`. `is_outside`: -1 if it is seen from its other end, else 0.
  Motion motion(const PlaceWindow& window, int index, unsigned axis, int is_outside) const noexcept {
    int moved = 0;
    int still = 0;
    int size = 0;
    const auto look = [&](unsigned k, int at) {
      const std::int8_t now = window.places(k)[at];
      const std::int8_t before = cuts_[k * PlaceWindow::kSize + static_cast<std::size_t>(at)];
      if (now == PlaceWindow::kNoPlace || before == PlaceWindow::kNoPlace) return 0;
      ++(now == before ? still : moved);
      size += std::abs(now - before);
      return now - before;
    };
    int way = 0;
    for (const unsigned k : {(axis + 1) % 3, (axis + 2) % 3}) {
      const int step = PlaceWindow::kStep[k];
      for (const int at : {index - step, index + step}) way += look(axis, at);
      for (const int at : {index, index + PlaceWindow::kStep[axis]}) {
        look(k, at - step);
        look(k, at);
      }
    }
    way = (way ^ is_outside) - is_outside;
    const bool is_far = 2 * symbols_ * size >= 192 * moved;
    return {.still = static_cast<unsigned>(std::min(still, 2)),
            .moved = moved == 0 ? 0U : 1U + (is_far ? 1U : 0U) + (moved > 1 ? 2U : 0U),
            .way = 1U + (way > 0 ? 1U : 0U) - (way < 0 ? 1U : 0U)};
  }

  /// The symbol of a level beside that of the former one: whether it is the same, else on which side it is,
  /// and then, symbol by symbol, whether it is farther. `expected`: the cut that others around lead to.
  template <class Coder>
  unsigned code_symbol(Coder& coder, int expected, const Motion& motion, unsigned former, unsigned symbol) {
    if (coder.bit(symbol == former, is_same_[3 * motion.moved + motion.still])) return former;
    const auto last = static_cast<unsigned>(symbols_) - 1;
    bool is_above = former == 0;
    if (former != 0 && former != last)
      is_above = coder.bit(symbol > former, is_above_[3 * class_of(left(expected, former)) + motion.way]);
    unsigned now = former;
    for (unsigned is_later = 0;; is_later = 1) {
      now = is_above ? now + 1 : now - 1;
      if (now == 0 || now == last) return now;
      const int ahead = is_above ? left(expected, now) : -left(expected, now);
      if (!coder.bit(symbol != now, is_farther_[(3 * class_of(ahead) + motion.far()) * 2 + is_later]))
        return now;
    }
  }

  /// Whether a level is the former one, where both have the same symbol.
  CountedBit& is_former(const Motion& motion) noexcept { return is_former_[3 * motion.moved + motion.still]; }

 private:
  /// Symbols from the middle of `symbol` to a cut.
  int left(int cut, unsigned symbol) const noexcept {
    const int middle = 32 * (2 * static_cast<int>(symbol) + 1) / symbols_ - 32;
    return ((cut - middle) * symbols_ + 32) >> 6;
  }
  static unsigned class_of(int left) noexcept { return static_cast<unsigned>(std::clamp(left, -2, 2) + 2); }

  const KnownSurface* surface_;
  int symbols_;
  std::array<CountedBit, 15> is_same_;   ///< by what has moved and what has not
  std::array<CountedBit, 15> is_above_;  ///< by where the expected cut is, and the way of those beside
  std::array<CountedBit, 30> is_farther_;
  std::array<CountedBit, 15> is_former_;  ///< as is_same_
  const Brick* own_ = nullptr;
  std::array<std::int8_t, 3 * PlaceWindow::kSize> cuts_;  ///< as in PlaceWindow
};

}  // namespace deltamesh::grid
