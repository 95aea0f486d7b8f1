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
  static constexpr int kAround = 2;  ///< nodes and edges on each side of the brick
  static constexpr int kWidth = kSide + 2 * kAround;
  static constexpr int kStep[3] = {1, kWidth, kWidth* kWidth};
  static constexpr std::size_t kSize = std::size_t{kWidth} * kWidth * kWidth;
  static constexpr int at(const Spot& spot) noexcept {
    return spot[0] + kAround + kWidth * (spot[1] + kAround + kWidth * (spot[2] + kAround));
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
    std::uint8_t* nodes = nodes_.data();
    for (int z = -kAround; z < kSide + kAround; ++z)
      for (int y = -kAround; y < kSide + kAround; ++y, nodes += kWidth)
        load_row(brick.rows[Brick::row_at(y, z)] >> (kMargin - kAround), nodes);
    // Those before are lower in z, else in y, else in x: the first 13 of those around.
    for (unsigned way = 0; way < 13; ++way) {
      const Brick* const near = brick.near[way];
      if (near == nullptr) continue;
      visit_cuts(*near, way, [&](unsigned slot, unsigned axis, int index) {
        set(axis, index, places[bricks.vertex(*near, slot, axis)]);
      });
    }
  }

  /// Calls `visit(slot, axis, index)` for the cut edges of `other` that a window has: the slot of the edge's
  /// first node there, the index here. `way`: from the window's brick, 0 to 26 by x, y, z.
  template <class Visit>
  static void visit_cuts(const Brick& other, unsigned way, const Visit& visit) {
    const Spot shift = {(static_cast<int>(way % 3) - 1) * kSide, (static_cast<int>(way / 3 % 3) - 1) * kSide,
                        (static_cast<int>(way / 9) - 1) * kSide};
    const auto first = [&](std::size_t axis) { return shift[axis] < 0 ? kSide - kAround : 0; };
    const auto end = [&](std::size_t axis) { return shift[axis] > 0 ? kAround : kSide; };
    constexpr std::uint64_t kAxes = Brick::cut_bit(0, 0) | Brick::cut_bit(0, 1) | Brick::cut_bit(0, 2);
    const std::uint64_t in_x = ((std::uint64_t{1} << end(0)) - (std::uint64_t{1} << first(0))) * kAxes;
    for (int z = first(2); z < end(2); ++z) {
      for (int y = first(1); y < end(1); ++y) {
        const unsigned slot_of_row = row_slot(y, z);
        for (std::uint64_t bits = other.cut[static_cast<std::size_t>(y + kSide * z)] & in_x; bits != 0;
             bits &= bits - 1) {
          const int bit = std::countr_zero(bits);
          const int x = bit % kSide;
          visit(slot_of_row + kSlots[0][static_cast<std::size_t>(x)], static_cast<unsigned>(bit / kSide),
                at({x + shift[0], y + shift[1], z + shift[2]}));
        }
      }
    }
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

  [[gnu::always_inline]] static void load_row(std::uint64_t row, std::uint8_t* nodes) noexcept {
    std::array<std::uint64_t, 3> states{};
    if (row != 0) {
      for (unsigned i = 0; i < 3; ++i)
        states[i] = kSpread[row >> (Brick::kInsideShift + 8 * i) & 255] + 2 * kSpread[row >> 8 * i & 255];
    }
    std::memcpy(nodes, states.data(), kWidth);
  }

  std::array<std::uint8_t, kSize + 8> nodes_{};
  std::array<std::int8_t, 3 * kSize> places_;
  std::array<std::uint16_t, 3 * kSize> known_;  ///< where `places_` has some
  std::size_t known_count_ = 0;
};

}  // namespace deltamesh::grid
