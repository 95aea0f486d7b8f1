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
#include <utility>

#include "grid/place_window.h"

namespace deltamesh::grid {

/// Places are in 64ths of an edge, from its middle: -32 to 32.
inline constexpr int kHalfEdge = 32;

/// A line of four nodes beside an edge, two on either side of its middle: where it is cut in the same
/// direction as the edge.
struct Column {
  std::int8_t step = 0;  ///< from the edge beside to the one that is cut, along the axis
  bool is_cut = false;
  std::int16_t height = 0;  ///< of that edge's middle; or far beyond the ends
};

/// By the edge's first node (inside: 0, outside: 1) and the states of the four nodes: s0 + 4 s1 + 16 s2 + 64
/// s3.
inline constexpr std::array<std::array<Column, 256>, 2> kColumns = [] {
  std::array<std::array<Column, 256>, 2> columns{};
  for (int first = 1; first <= 2; ++first) {
    for (int i = 0; i < 256; ++i) {
      const int s[4] = {i & 3, i >> 2 & 3, i >> 4 & 3, i >> 6};
      Column column;
      const auto is_last = [&](int state) { return state == 3 - first; };
      if (s[1] == first && is_last(s[2])) {
        column = {0, true, 0};
      } else if (s[1] == first && s[2] == first) {
        column = is_last(s[3]) ? Column{1, true, 2 * kHalfEdge}
                               : Column{0, false, static_cast<std::int16_t>(s[3] != 0 ? 108 : 58)};
      } else if (is_last(s[1]) && is_last(s[2])) {
        column = s[0] == first ? Column{-1, true, -2 * kHalfEdge}
                               : Column{0, false, static_cast<std::int16_t>(s[0] != 0 ? -108 : -58)};
      }
      columns[static_cast<std::size_t>(first - 1)][static_cast<std::size_t>(i)] = column;
    }
  }
  return columns;
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

template <unsigned kAxis>
class PlaceSurroundings {
 public:
  /// Of the edge of kAxis that begins at the node `index`.
  [[gnu::always_inline]] PlaceSurroundings(const PlaceWindow& window, int index) noexcept
      : nodes_(window.nodes() + index),
        own_(window.places(kAxis) + index),
        next_(window.places((kAxis + 1) % 3) + index),
        last_(window.places((kAxis + 2) % 3) + index),
        is_outside_(nodes_[0] != PlaceWindow::kInsideNode),
        columns_(kColumns[is_outside_ ? 1 : 0].data()) {}

  /// Whether the edge begins outside: then everything is seen from its other end.
  bool is_outside() const noexcept { return is_outside_; }

  [[gnu::always_inline]] PlaceContext context() const noexcept {
    const Height west = height(-kNext);
    const Height north = height(-kLast);
    int mean = (weighted(west) + weighted(height(kNext)) + weighted(north) + weighted(height(kLast))) >> 3;
    // All are looked at, known or not: branches would go wrong often.
    const Height beyond_west = height(-2 * kNext);
    const Height beyond_north = height(-2 * kLast);
    const Height between = height(-kNext - kLast);
    const Height across = height(kNext < kLast ? kNext - kLast : kLast - kNext);
    const int turn = west.value - north.value;
    Candidates candidates;
    candidates.add(2 * west.value - beyond_west.value, west.is_known & beyond_west.is_known);
    candidates.add(2 * north.value - beyond_north.value, north.is_known & beyond_north.is_known);
    const bool both = west.is_known & north.is_known;
    candidates.add(west.value + north.value - between.value, both & between.is_known);
    // Of the two across, the one that comes earlier.
    candidates.add(across.value + (kNext < kLast ? turn : -turn), both & across.is_known);
    int smooth = candidates.mean();
    End first = end(0);
    End last = end(kOwn);
    if (is_outside_) {
      mean = -mean;
      smooth = -smooth;
      std::swap(first, last);
    }
    const unsigned ends_known = (first.is_known ? 1U : 0U) + (last.is_known ? 2U : 0U);
    int line = mean;
    if (ends_known != 0) {
      const int by_ends = ends_known == 3   ? (first.distance - last.distance) >> 1
                          : ends_known == 1 ? (first.distance - kHalfEdge) >> 1
                                            : (kHalfEdge - last.distance) >> 1;
      line = (mean + by_ends) >> 1;
    }
    const unsigned spread = candidates.spread_class();
    const unsigned smooth_class =
        candidates.count() == 0 ? 0U : 1U + static_cast<unsigned>(std::clamp((smooth + 40) >> 2, 0, 19));
    return {(first.kind * 8 + last.kind) * 6 + static_cast<unsigned>(std::clamp((mean + 48) >> 4, 0, 5)),
            (smooth_class * 4 + spread) * 6 + static_cast<unsigned>(std::clamp((line + 24) >> 3, 0, 5)),
            ends_known * 4 + spread};
  }

 private:
  static constexpr int kOwn = PlaceWindow::kStep[kAxis];
  static constexpr int kNext = PlaceWindow::kStep[(kAxis + 1) % 3];
  static constexpr int kLast = PlaceWindow::kStep[(kAxis + 2) % 3];

  struct Height {
    int value;
    bool is_known;
  };

  class Candidates {
   public:
    [[gnu::always_inline]] void add(int height, bool is_known) noexcept {
      least_ = std::min(least_, is_known ? height : kFar);
      most_ = std::max(most_, is_known ? height : -kFar);
      sum_ += is_known ? height : 0;
      count_ += is_known ? 1 : 0;
    }
    unsigned count() const noexcept { return count_; }
    int mean() const noexcept { return sum_ * kOneOver[count_] >> 8; }
    unsigned spread_class() const noexcept {
      const int spread = most_ - least_;
      return count_ < 2 ? 0 : 1U + (spread >= 10 ? 1U : 0U) + (spread >= 40 ? 1U : 0U);
    }

   private:
    static constexpr int kOneOver[5] = {0, 256, 128, 85, 64};
    static constexpr int kFar = 1 << 20;
    int least_ = kFar;
    int most_ = -kFar;
    int sum_ = 0;
    unsigned count_ = 0;
  };

  /// The cuts of the four edges across at one end.
  struct End {
    int distance = 0;   ///< mean, from the end, 64ths
    unsigned kind = 0;  ///< 2 to 7 by distance; 1: some are cut, none is known yet; 0: none is cut
    bool is_known = false;
  };

  /// Of the four nodes of a column, two bits each.
  [[gnu::always_inline]] static std::size_t states(const std::uint8_t* node) noexcept {
    if constexpr (kAxis == 0) {
      std::uint32_t four = 0;
      std::memcpy(&four, node - 1, sizeof(four));
      return four * (1U << 24 | 1U << 18 | 1U << 12 | 1U << 6) >> 24;
    }
    return node[-kOwn] + 4U * node[0] + 16U * node[kOwn] + 64U * node[2 * kOwn];
  }

  [[gnu::always_inline]] Height height(int away) const noexcept {
    const Column& column = columns_[states(nodes_ + away)];
    const std::int8_t place = own_[away + column.step * kOwn];
    const bool is_known = column.is_cut & (place != PlaceWindow::kNoPlace);
    return {column.height + (is_known ? place : 0), is_known};
  }
  static int weighted(const Height& height) noexcept {
    return height.is_known ? 3 * height.value : height.value;
  }

  [[gnu::always_inline]] End end(int away) const noexcept {
    const std::uint8_t* const node = nodes_ + away;
    int sum = 0;
    unsigned known = 0;
    unsigned cut = 0;
    // `begins`: the edge begins at this end.
    const auto look = [&](const std::int8_t* places, int edge, int other, bool begins) {
      const bool is_cut = node[other] + node[0] == 3;
      const std::int8_t place = places[away + edge];
      const bool is_known = is_cut & (place != PlaceWindow::kNoPlace);
      cut += is_cut ? 1 : 0;
      known += is_known ? 1 : 0;
      sum += is_known ? kHalfEdge + (begins ? place : -place) : 0;
    };
    look(next_, -kNext, -kNext, false);
    look(next_, 0, kNext, true);
    look(last_, -kLast, -kLast, false);
    look(last_, 0, kLast, true);
    End result;
    result.is_known = known > 0;
    static constexpr int kOneOver[5] = {0, 256, 128, 85, 64};
    result.distance = sum * kOneOver[known] >> 8;
    result.kind =
        known > 0 ? 2U + static_cast<unsigned>(std::min(5, result.distance * 6 / 64)) : std::min(cut, 1U);
    return result;
  }

  const std::uint8_t* nodes_;
  const std::int8_t* own_;
  const std::int8_t* next_;
  const std::int8_t* last_;
  bool is_outside_;
  const Column* columns_;
};

}  // namespace deltamesh::grid
