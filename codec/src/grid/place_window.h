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
  static constexpr int kHalfEdge = 32;  ///< places are in 64ths of an edge, from its middle: -32 to 32

  /// `places`: of vertices; those of bricks before `brick` [GRD-9] are known.
  void load(const Brick& brick, const Bricks& bricks, std::span<const std::int8_t> places) {
    for (std::size_t i = 0; i < known_count_; ++i) {
      const auto [at_edge, at_end] = known_[i];
      doubles_[at_edge] = 0;
      cuts_[at_edge] = 0;
      cuts_[at_end] = 0;
    }
    known_count_ = 0;
    std::uint8_t* nodes = nodes_.data();
    for (int z = -kAround; z < kSide + kAround; ++z)
      for (int y = -kAround; y < kSide + kAround; ++y, nodes += kWidth)
        load_row(brick.rows[Brick::row_at(y, z)] >> (kMargin - kAround), nodes);
    // Those before are lower in z, else in y, else in x: the first 13 of those around.
    for (unsigned way = 0; way < 13; ++way)
      if (brick.near[way] != nullptr) load_places(*brick.near[way], way, bricks, places);
  }

  /// Of an edge that had none.
  [[gnu::always_inline]] void set(unsigned axis, int index, std::int8_t place) noexcept {
    const auto node = static_cast<std::size_t>(index);
    const auto step = static_cast<std::size_t>(kStep[axis]);
    const std::size_t at_edge = axis * kSize + node;
    const bool is_cut = nodes_[node] + nodes_[node + step] == kInsideNode + kOutsideNode;
    doubles_[at_edge] = static_cast<std::int8_t>(2 * place + 1);
    const auto add = [&](std::size_t at, int distance) {
      cuts_[at] = static_cast<std::uint16_t>(cuts_[at] + (is_cut ? kOneCut + distance : 0));
    };
    add(at_edge, kHalfEdge + place);
    add(at_edge + step, kHalfEdge - place);
    known_[known_count_++] = {static_cast<std::uint16_t>(at_edge),
                              static_cast<std::uint16_t>(at_edge + step)};
  }

  std::int8_t place(unsigned axis, int index) const noexcept {
    const std::int8_t twice = doubles(axis)[index];
    return twice == 0 ? kNoPlace : static_cast<std::int8_t>(twice >> 1);
  }

  const std::uint8_t* nodes() const noexcept { return nodes_.data(); }
  /// Of edges: twice the place, and 1; 0 if it is not known.
  const std::int8_t* doubles(unsigned axis) const noexcept { return doubles_.data() + axis * kSize; }
  /// Of nodes: kOneCut times the number of edges of the axis that begin or end there, have different ends and
  /// a known place, and the sum of the distances of these from the node.
  const std::uint16_t* cuts(unsigned axis) const noexcept { return cuts_.data() + axis * kSize; }
  static constexpr int kOneCut = 1 << 9;

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

  void load_places(const Brick& other, unsigned way, const Bricks& bricks,
                   std::span<const std::int8_t> places) {
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
          const auto axis = static_cast<unsigned>(bit / kSide);
          const int x = bit % kSide;
          const std::uint32_t vertex = bricks.vertex(other, slot_of_row + kSlots[0][x], axis);
          set(axis, at({x + shift[0], y + shift[1], z + shift[2]}), places[vertex]);
        }
      }
    }
  }

  std::array<std::uint8_t, kSize + kStep[2]> nodes_{};  ///< those behind them are never read with a meaning
  std::array<std::int8_t, 3 * kSize> doubles_{};
  std::array<std::uint16_t, 3 * kSize + kStep[2]> cuts_{};
  /// Places in `doubles_` that have one, and where the edge ends in `cuts_`.
  std::array<std::array<std::uint16_t, 2>, 3 * kSize> known_;
  std::size_t known_count_ = 0;
};

}  // namespace deltamesh::grid
