// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a known surface tells of one that grows: where it may have faces, and its signs [MAP-28].
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

#include "entropy/coder/counted_bit.h"
#include "grid/known/surface.h"
#include "grid/waiting_cubes.h"
#include "grid/window.h"

namespace deltamesh::grid {

class KnownGrowth {
 public:
  /// `surface`: null where nothing is known.
  explicit KnownGrowth(const KnownSurface* surface) noexcept : surface_(surface) {
    constexpr CountedBit kLikely(61000);
    constexpr CountedBit kUnlikely(65535 - 61000);
    for (std::size_t i = 0; i < flags_.size(); ++i) flags_[i] = (i / kOfMixed & 1) != 0 ? kLikely : kUnlikely;
    for (std::size_t i = 0; i < signs_.size(); ++i) signs_[i] = (i & 1) != 0 ? kLikely : kUnlikely;
    for (std::size_t i = 0; i < patterns_.size(); ++i) patterns_[i] = (i & 1) == 0 ? kLikely : kUnlikely;
  }

  /// Nodes of cubes with faces that stay are known, and cubes with faces that go wait.
  void begin(Bricks& bricks, WaitingCubes& waiting) const {
    if (surface_ == nullptr) return;
    for (const KnownSurface::Cube& cube : surface_->cubes())
      if ((cube.kind() & KnownSurface::kStays) != 0) set_corners(bricks, cube);
    for (const KnownSurface::Cube& cube : surface_->cubes())
      if ((cube.kind() & KnownSurface::kGoes) != 0) waiting.add(bricks.get(cube.brick->at), cube.place);
  }

  /// Null: as without a known surface. `faceless`: of the cubes across faces.
  CountedBit* flag_model(const Brick& brick, unsigned place, const Corners& corners,
                         unsigned faceless) noexcept {
    const Brick* const known = find(brick);
    if (known == nullptr || known->cubes[place] == 0) return nullptr;
    const unsigned is_mixed = corners.outside != 0 && corners.inside != 0 ? 1 : 0;
    const unsigned count = corners.known() == 255 ? 2 : corners.known() != 0 ? 1 : 0;
    const unsigned index =
        ((known->cubes[place] - 1U) * 4 + wrong_corners(corners, Corners(*known, place))) * 2 + is_mixed;
    return &flags_[index * kOfMixed + count * 4 + std::min(faceless, 3U)];
  }

  /// Likewise, of a corner that is not known. `majority`: see Window.
  CountedBit* sign_model(const Brick& brick, unsigned place, const Corners& corners, unsigned corner,
                         unsigned majority) noexcept {
    const Brick* const known = find(brick);
    if (known == nullptr) return nullptr;
    const Corners before(*known, place);
    if ((before.known() >> corner & 1) == 0) return nullptr;
    const unsigned was_outside = before.outside >> corner & 1;
    const unsigned beside = 1U << (corner ^ 1) | 1U << (corner ^ 2) | 1U << (corner ^ 4);
    const auto outside = static_cast<unsigned>(std::popcount(corners.outside & beside));
    const auto inside = static_cast<unsigned>(std::popcount(corners.inside & beside));
    const unsigned index = (wrong_corners(corners, before) * 3 + majority) * 16 + 4 * outside + inside;
    return &signs_[2 * index + was_outside];
  }

  /// The faces that go of a cube all of whose corners were known, and the model of whether the new ones are
  /// the same; null if there are none.
  struct Gone {
    const Pattern* pattern = nullptr;
    CountedBit* model = nullptr;
  };
  Gone gone(const Brick& brick, unsigned place, Signs signs) noexcept {
    const Brick* const known = find(brick);
    if (known == nullptr || (known->cubes[place] & KnownSurface::kGoes) == 0) return {};
    const Corners before(*known, place);
    if (before.known() != 255) return {};
    const unsigned is_other = before.outside == signs ? 0 : 1;
    return {&surface_->gone(*known, place),
            &patterns_[is_other + (known->cubes[place] & KnownSurface::kStays)]};
  }

 private:
  static constexpr std::size_t kOfMixed =
      3 * 4;  ///< models of flags with the same `is_mixed` and those before

  void set_corners(Bricks& bricks, const KnownSurface::Cube& cube) const {
    const Corners before(*cube.brick, cube.place);
    bricks.set_corners(bricks.get(cube.brick->at), cube.place, before.outside, before.inside);
  }

  /// Those that are on the other side now, 3 at most.
  static unsigned wrong_corners(const Corners& now, const Corners& before) noexcept {
    const Signs wrong = (now.outside & before.inside) | (now.inside & before.outside);
    return std::min(static_cast<unsigned>(std::popcount(wrong)), 3U);
  }

  const Brick* find(const Brick& brick) noexcept {
    if (surface_ == nullptr) return nullptr;
    if (brick.number != last_) known_ = surface_->bricks().find(brick.at);
    last_ = brick.number;
    return known_;
  }

  const KnownSurface* surface_;
  std::uint32_t last_ = 0xffffffff;  ///< brick that find() was asked for, and what it found
  const Brick* known_ = nullptr;
  std::array<CountedBit, std::size_t{3} * 4 * 2 * kOfMixed> flags_;
  std::array<CountedBit, std::size_t{4} * 3 * 16 * 2> signs_;
  std::array<CountedBit, 4> patterns_;
};

}  // namespace deltamesh::grid
