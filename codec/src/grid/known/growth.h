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
    patterns_ = {kLikely, kUnlikely};
    for (std::size_t i = 0; i < beside_flags_.size(); ++i)
      beside_flags_[i] = i < kOfMixed ? kUnlikely : CountedBit(kFreshBeside[i % 4]);
  }

  /// Puts the cubes that had faces in the queue.
  void begin(Bricks& bricks, WaitingCubes& waiting) const {
    if (surface_ == nullptr) return;
    for (const KnownSurface::Cube& cube : surface_->cubes())
      waiting.add(bricks.get(cube.brick->at), cube.place);
  }

  /// Null: as without a known surface. `faceless`: of the cubes across faces.
  CountedBit* flag_model(const Brick& brick, unsigned place, const Corners& corners,
                         unsigned faceless) noexcept {
    const Brick* const known = find(brick);
    if (known == nullptr) return nullptr;
    const Corners before(*known, place);
    const unsigned wrong = wrong_corners(corners, before);
    const unsigned beside = std::min(faceless, 3U);
    if (known->cubes[place] == 0) {
      if ((before.outside & corners.known()) == 0 || (before.inside & corners.known()) == 0) return nullptr;
      const int count = std::popcount(corners.known());
      return &beside_flags_[wrong * kOfMixed + (count == 8 ? 2 : count > 4 ? 1 : 0) * 4 + beside];
    }
    const unsigned is_mixed = corners.outside != 0 && corners.inside != 0 ? 1 : 0;
    const unsigned count = corners.known() == 255 ? 2 : corners.known() != 0 ? 1 : 0;
    return &flags_[(2 * wrong + is_mixed) * kOfMixed + count * 4 + beside];
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

  /// The former faces of a cube all of whose corners were known, and the model of whether the new ones are
  /// the same; null if there are none.
  struct Former {
    const Pattern* pattern = nullptr;
    CountedBit* model = nullptr;
  };
  Former former(const Brick& brick, unsigned place, Signs signs) noexcept {
    const Brick* const known = find(brick);
    if (known == nullptr || known->cubes[place] == 0) return {};
    const Corners before(*known, place);
    if (before.known() != 255) return {};
    return {&surface_->pattern(*known, place), &patterns_[before.outside == signs ? 0 : 1]};
  }

 private:
  static constexpr std::size_t kOfMixed =
      3 * 4;  ///< models of flags with the same `is_mixed` and those before
  /// Where corners have changed, by how many cubes across faces have none.
  static constexpr std::array<std::uint16_t, 4> kFreshBeside = {49152, 24576, 8192, 4096};

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
  std::array<CountedBit, std::size_t{4} * 2 * kOfMixed> flags_;
  std::array<CountedBit, 4 * kOfMixed> beside_flags_;  ///< flags of cubes that had no faces
  std::array<CountedBit, std::size_t{4} * 3 * 16 * 2> signs_;
  std::array<CountedBit, 2> patterns_;  ///< by whether a corner has changed
};

}  // namespace deltamesh::grid
