// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A brick and its surroundings, spread out so that whatever is near an edge is a fixed step away.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "grid/brick.h"
#include "grid/bricks.h"

namespace deltamesh::grid {

class PlaceWindow {
 public:
  static constexpr int kStep[3] = {1, kReach, kReach* kReach};
  static constexpr std::size_t kSize = std::size_t{kReach} * kReach * kReach;
  static constexpr int at(const Spot& spot) noexcept {
    return spot[0] + kMargin + kReach * (spot[1] + kMargin + kReach * (spot[2] + kMargin));
  }

  /// Of a node.
  enum State : std::uint8_t { kUnknown = 0, kInsideNode = 1, kOutsideNode = 2 };
  /// Of a place on an edge that is not known.
  static constexpr std::int8_t kNoPlace = 127;

  PlaceWindow() noexcept { places_.fill(kNoPlace); }

  /// `places`: of vertices; those of bricks before `brick` [GRD-9] are known.
  void load(const Brick& brick, const Bricks& bricks, std::span<const std::int8_t> places) {
    for (std::size_t i = 0; i < known_count_; ++i) places_[known_[i]] = kNoPlace;
    known_count_ = 0;
    for (std::size_t row = 0; row < brick.rows.size(); ++row) load_row(brick.rows[row], row);
    // Those before are lower in z, else in y, else in x: the first 13 of those around.
    for (unsigned way = 0; way < 13; ++way)
      if (brick.near[way] != nullptr) load_places(*brick.near[way], way, bricks, places);
  }

  /// Of an edge that had none.
  void set(unsigned axis, int index, std::int8_t place) noexcept {
    const std::size_t at_edge = axis * kSize + static_cast<std::size_t>(index);
    places_[at_edge] = place;
    known_[known_count_++] = static_cast<std::uint16_t>(at_edge);
  }

  const std::uint8_t* nodes() const noexcept { return nodes_.data(); }
  const std::int8_t* places(unsigned axis) const noexcept { return places_.data() + axis * kSize; }

 private:
  /// Eight bits as eight bytes.
  static constexpr std::array<std::uint64_t, 256> kSpread = [] {
    std::array<std::uint64_t, 256> spread{};
    for (unsigned bits = 0; bits < 256; ++bits)
      for (unsigned i = 0; i < 8; ++i) spread[bits] |= std::uint64_t{bits >> i & 1} << (8 * i);
    return spread;
  }();

  [[gnu::always_inline]] void load_row(std::uint64_t row, std::size_t number) noexcept {
    std::uint8_t* const to = nodes_.data() + number * kReach;
    std::array<std::uint64_t, 3> states{};
    if (row != 0) {
      for (unsigned i = 0; i < 3; ++i)
        states[i] = kSpread[row >> (Brick::kInsideShift + 8 * i) & 255] + 2 * kSpread[row >> 8 * i & 255];
    }
    std::memcpy(to, states.data(), kReach);
  }

  void load_places(const Brick& other, unsigned way, const Bricks& bricks,
                   std::span<const std::int8_t> places) {
    const Spot shift = {(static_cast<int>(way % 3) - 1) * kSide, (static_cast<int>(way / 3 % 3) - 1) * kSide,
                        (static_cast<int>(way / 9) - 1) * kSide};
    const auto first = [&](std::size_t axis) { return shift[axis] < 0 ? kSide - kMargin : 0; };
    const auto end = [&](std::size_t axis) { return shift[axis] > 0 ? kMargin : kSide; };
    const unsigned in_x = (1U << end(0)) - (1U << first(0));
    for (int z = first(2); z < end(2); ++z) {
      for (int y = first(1); y < end(1); ++y) {
        const auto row = static_cast<std::size_t>(y + kSide * z);
        const unsigned cut[3] = {other.cut[0][row] & in_x, other.cut[1][row] & in_x,
                                 other.cut[2][row] & in_x};
        if ((cut[0] | cut[1] | cut[2]) == 0) continue;
        for (unsigned axis = 0; axis < 3; ++axis) {
          for (unsigned bits = cut[axis]; bits != 0; bits &= bits - 1) {
            const int x = std::countr_zero(bits);
            const std::uint32_t vertex = bricks.vertex(other, place_of({x, y, z}), axis);
            set(axis, at({x + shift[0], y + shift[1], z + shift[2]}), places[vertex]);
          }
        }
      }
    }
  }

  std::array<std::uint8_t, kSize + 8> nodes_{};
  std::array<std::int8_t, 3 * kSize> places_;
  std::array<std::uint16_t, 3 * kSize> known_;  ///< where `places_` has some
  std::size_t known_count_ = 0;
};

}  // namespace deltamesh::grid
