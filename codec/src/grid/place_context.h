// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Where a surface probably cuts an edge: by the cuts beside it, and by those at its ends [GRD-10].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "grid/place_window.h"

namespace deltamesh::grid {

/// A line of four nodes beside an edge, two on either side of its middle: where it is cut in the same
/// direction as the edge.
struct Column {
  std::int16_t twice_height = 0;  ///< of the middle of that edge; or far beyond the ends
  std::int8_t step = 0;           ///< from the edge beside to the one that is cut, along the axis
  std::int8_t cut = 0;            ///< -1 if there is one
};

/// By the edge's first node (inside: 0, outside: 1) and the states of the four nodes: s0 + 4 s1 + 16 s2 + 64
/// s3.
inline constexpr std::array<std::array<Column, 256>, 2> kColumns = [] {
  constexpr std::int16_t kEdge = 4 * PlaceWindow::kHalfEdge;
  std::array<std::array<Column, 256>, 2> columns{};
  for (int first = 1; first <= 2; ++first) {
    for (int i = 0; i < 256; ++i) {
      const int s[4] = {i & 3, i >> 2 & 3, i >> 4 & 3, i >> 6};
      Column column;
      const auto is_last = [&](int state) { return state == 3 - first; };
      if (s[1] == first && is_last(s[2])) {
        column = {0, 0, -1};
      } else if (s[1] == first && s[2] == first) {
        column = is_last(s[3]) ? Column{kEdge, 1, -1}
                               : Column{static_cast<std::int16_t>(s[3] != 0 ? 216 : 116), 0, 0};
      } else if (is_last(s[1]) && is_last(s[2])) {
        column = s[0] == first ? Column{-kEdge, -1, -1}
                               : Column{static_cast<std::int16_t>(s[0] != 0 ? -216 : -116), 0, 0};
      }
      columns[static_cast<std::size_t>(first - 1)][static_cast<std::size_t>(i)] = column;
    }
  }
  return columns;
}();

/// By the states of an edge's nodes, s1 + 2 s2 - 3, and those of the four beside it: bit 0 if the edge to it
/// is cut at the first node, bit 1 if it is at the other.
inline constexpr std::array<std::array<std::uint8_t, 256>, 4> kCutAcross = [] {
  std::array<std::array<std::uint8_t, 256>, 4> cut{};
  for (int own = 0; own < 4; ++own) {
    for (int i = 0; i < 256; ++i) {
      const int first = (i >> 2 & 3) + 1 + own % 2 == 3 ? 1 : 0;
      const int other = (i >> 4 & 3) + 1 + own / 2 == 3 ? 2 : 0;
      cut[static_cast<std::size_t>(own)][static_cast<std::size_t>(i)] =
          static_cast<std::uint8_t>(first + other);
    }
  }
  return cut;
}();

/// Of a symbol and its models.
struct PlaceContext {
  unsigned ends;     ///< model of the first table
  unsigned smooth;   ///< of the second
  unsigned weights;  ///< set of mixing weights
};
inline constexpr std::size_t kEndContexts = 8 * 8 * 6;
inline constexpr std::size_t kSmoothContexts = 21 * 4 * 6;
inline constexpr std::size_t kPlaceWeights = 16;

/// All without branches, which would often go wrong: what is known is -1, else 0, and selects by `&`.
template <unsigned kAxis>
class PlaceSurroundings {
 public:
  /// Of the edge of kAxis that begins at the node `index`.
  [[gnu::always_inline]] PlaceSurroundings(const PlaceWindow& window, int index) noexcept
      : nodes_(window.nodes() + index),
        doubles_(window.doubles(kAxis) + index),
        next_cuts_(window.cuts((kAxis + 1) % 3) + index),
        last_cuts_(window.cuts((kAxis + 2) % 3) + index),
        outside_(-(nodes_[0] >> 1)),
        columns_(kColumns[static_cast<std::size_t>(nodes_[0] >> 1)].data()) {}

  /// -1 if the edge begins outside, else 0: then everything is seen from its other end.
  int is_outside() const noexcept { return outside_; }

  [[gnu::always_inline]] PlaceContext context() const noexcept {
    const std::array<std::size_t, 4> beside = {states(-kNext), states(kNext), states(-kLast), states(kLast)};
    const Height west(*this, -kNext, beside[0]);
    const Height north(*this, -kLast, beside[2]);
    const int sum = west.weighted() + Height(*this, kNext, beside[1]).weighted() + north.weighted() +
                    Height(*this, kLast, beside[3]).weighted();
    const Height beyond_west(*this, -2 * kNext);
    const Height beyond_north(*this, -2 * kLast);
    const Height between(*this, -kNext - kLast);
    const Height across(*this, kNext < kLast ? kNext - kLast : kLast - kNext);
    const int turn = west.value - north.value;
    Candidates candidates;
    candidates.add(2 * west.value - beyond_west.value, west.known & beyond_west.known);
    candidates.add(2 * north.value - beyond_north.value, north.known & beyond_north.known);
    const int both = west.known & north.known;
    candidates.add(west.value + north.value - between.value, both & between.known);
    // Of the two across, the one that comes earlier.
    candidates.add(across.value + (kNext < kLast ? turn : -turn), both & across.known);
    const int mean = seen(sum >> 3);
    const int smooth = seen(candidates.mean());
    const std::uint8_t* const cut =
        kCutAcross[(nodes_[0] + 2U * nodes_[kOwn] - 3) % kCutAcross.size()].data();
    const unsigned are_cut = cut[beside[0]] | cut[beside[1]] | cut[beside[2]] | cut[beside[3]];
    const End first = end(kOwn & outside_, are_cut >> -outside_ & 1);
    const End last = end(kOwn & ~outside_, are_cut >> (1 + outside_) & 1);
    const int first_known = first.kind > 1 ? 1 : 0;
    const int last_known = last.kind > 1 ? 1 : 0;
    const int line = (mean + ((first.distance - last.distance) >> 1)) >> (first_known | last_known);
    const int spread = candidates.spread_class();
    const int smooth_class = (1 + std::clamp((smooth + 40) >> 2, 0, 19)) & candidates.any();
    return {static_cast<unsigned>((first.kind * 8 + last.kind) * 6 + std::clamp((mean + 48) >> 4, 0, 5)),
            static_cast<unsigned>((smooth_class * 4 + spread) * 6 + std::clamp((line + 24) >> 3, 0, 5)),
            static_cast<unsigned>((first_known + 2 * last_known) * 4 + spread)};
  }

 private:
  static constexpr int kOwn = PlaceWindow::kStep[kAxis];
  static constexpr int kNext = PlaceWindow::kStep[(kAxis + 1) % 3];
  static constexpr int kLast = PlaceWindow::kStep[(kAxis + 2) % 3];
  static constexpr int kOneOver[5] = {0, 256, 128, 85, 64};

  int seen(int height) const noexcept { return (height ^ outside_) - outside_; }

  /// Of the cut of a column, 64ths of an edge; -1 if its place is known.
  struct Height {
    [[gnu::always_inline]] Height(const PlaceSurroundings& own, int away, std::size_t states) noexcept {
      const Column& column = own.columns_[states];
      const int twice = column.twice_height + (own.doubles_[away + column.step * kOwn] & column.cut);
      value = twice >> 1;
      known = -(twice & 1);
    }
    [[gnu::always_inline]] Height(const PlaceSurroundings& own, int away) noexcept
        : Height(own, away, own.states(away)) {}
    int weighted() const noexcept { return value + ((2 * value) & known); }

    int value;
    int known;
  };

  class Candidates {
   public:
    [[gnu::always_inline]] void add(int height, int known) noexcept {
      least_ = std::min(least_, ((height - kFar) & known) + kFar);
      most_ = std::max(most_, ((height + kFar) & known) - kFar);
      sum_ += height & known;
      count_ -= known;
    }
    int any() const noexcept { return -count_ >> 3; }
    int mean() const noexcept { return sum_ * kOneOver[count_] >> 8; }
    int spread_class() const noexcept {
      const int spread = most_ - least_;
      return (1 - ((9 - spread) >> 31) - ((39 - spread) >> 31)) & (1 - count_) >> 3;
    }

   private:
    static constexpr int kFar = 1 << 20;
    int least_ = kFar;
    int most_ = -kFar;
    int sum_ = 0;
    int count_ = 0;
  };

  /// The cuts of the four edges across at one end.
  struct End {
    int distance;  ///< mean, from the end, 64ths; its middle if none is known
    int kind;      ///< 2 to 7 by distance; 1: some are cut, none is known yet; 0: none is cut
  };

  /// Of the four nodes of a column, two bits each.
  [[gnu::always_inline]] std::size_t states(int away) const noexcept {
    const std::uint8_t* const node = nodes_ + away;
    if constexpr (kAxis == 0) {
      std::uint32_t four = 0;
      std::memcpy(&four, node - 1, sizeof(four));
      return four * (1U << 24 | 1U << 18 | 1U << 12 | 1U << 6) >> 24;
    }
    return node[-kOwn] + 4U * node[0] + 16U * node[kOwn] + 64U * node[2 * kOwn];
  }

  /// `is_cut`: 1 if some edge across is, else 0.
  [[gnu::always_inline]] End end(int away, unsigned is_cut) const noexcept {
    const int cuts = next_cuts_[away] + last_cuts_[away];
    const int count = cuts / PlaceWindow::kOneCut;
    const int if_known = -count >> 3;
    const int distance = (cuts % PlaceWindow::kOneCut) * kOneOver[count] >> 8;
    const int kind =
        ((2 + std::min(5, distance * 6 >> 6)) & if_known) | (static_cast<int>(is_cut) & ~if_known);
    return {distance + (PlaceWindow::kHalfEdge & ~if_known), kind};
  }

  const std::uint8_t* nodes_;
  const std::int8_t* doubles_;
  const std::uint16_t* next_cuts_;
  const std::uint16_t* last_cuts_;
  int outside_;
  const Column* columns_;
};

}  // namespace deltamesh::grid
