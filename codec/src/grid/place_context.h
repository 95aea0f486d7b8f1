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

/// Places are in 64ths of an edge, from its middle: -32 to 32.
inline constexpr int kHalfEdge = 32;

/// A line of four nodes beside an edge, two on either side of its middle: where it is cut in the same
/// direction as the edge.
struct Column {
  std::int8_t step = 0;     ///< from the edge beside to the one that is cut, along the axis
  std::int8_t cut = 0;      ///< -1 if there is one
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
        column = {0, -1, 0};
      } else if (s[1] == first && s[2] == first) {
        column = is_last(s[3]) ? Column{1, -1, 2 * kHalfEdge}
                               : Column{0, 0, static_cast<std::int16_t>(s[3] != 0 ? 108 : 58)};
      } else if (is_last(s[1]) && is_last(s[2])) {
        column = s[0] == first ? Column{-1, -1, -2 * kHalfEdge}
                               : Column{0, 0, static_cast<std::int16_t>(s[0] != 0 ? -108 : -58)};
      }
      columns[static_cast<std::size_t>(first - 1)][static_cast<std::size_t>(i)] = column;
    }
  }
  return columns;
}();

inline constexpr std::size_t kEndContexts = 8 * 8 * 6;
inline constexpr unsigned kSmoothClasses = 21;  ///< of places by candidates; 0 without
inline constexpr std::size_t kOfSmoothClass = 4 * 6;
inline constexpr std::size_t kSmoothContexts = kSmoothClasses * kOfSmoothClass;
/// The middle of the places of a class, from 1 on.
constexpr int smooth_of_class(unsigned smooth_class) noexcept {
  return 4 * static_cast<int>(smooth_class) - 42;
}
inline constexpr std::size_t kPlaceWeights = 16;

/// Of a symbol and its models.
struct PlaceContext {
  unsigned ends;     ///< model of the first table
  unsigned smooth;   ///< of the second
  unsigned weights;  ///< set of mixing weights

  /// Where the edge is cut as far as the second model's context tells [MAP-29].
  int expected() const noexcept {
    const auto smooth_class = static_cast<unsigned>(smooth / kOfSmoothClass);
    const int line = 8 * static_cast<int>(smooth % 6) - 20;
    return smooth_class == 0 ? line : (smooth_of_class(smooth_class) + line) / 2;
  }
};

/// All without branches, which would often go wrong: what is known is -1, else 0, and selects by `&`.
template <unsigned kAxis>
class PlaceSurroundings {
 public:
  /// Of the edge of kAxis that begins at the node `index`.
  [[gnu::always_inline]] PlaceSurroundings(const PlaceWindow& window, int index) noexcept
      : nodes_(window.nodes() + index),
        own_(window.places(kAxis) + index),
        next_(window.places((kAxis + 1) % 3) + index),
        last_(window.places((kAxis + 2) % 3) + index),
        outside_(-(nodes_[0] >> 1)),
        columns_(kColumns[static_cast<std::size_t>(nodes_[0] >> 1)].data()) {}

  /// -1 if the edge begins outside, else 0: then everything is seen from its other end.
  int is_outside() const noexcept { return outside_; }

  [[gnu::always_inline]] PlaceContext context() const noexcept {
    const Height west = height(-kNext);
    const Height north = height(-kLast);
    const int sum = weighted(west) + weighted(height(kNext)) + weighted(north) + weighted(height(kLast));
    const Height beyond_west = height(-2 * kNext);
    const Height beyond_north = height(-2 * kLast);
    const Height between = height(-kNext - kLast);
    const Height across = height(kNext < kLast ? kNext - kLast : kLast - kNext);
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
    const End begin = end(0);
    const End other = end(kOwn);
    const int swap_kind = (begin.kind ^ other.kind) & outside_;
    const int swap_distance = (begin.distance ^ other.distance) & outside_;
    const int first_kind = begin.kind ^ swap_kind;
    const int last_kind = other.kind ^ swap_kind;
    const int by_ends = ((begin.distance ^ swap_distance) - (other.distance ^ swap_distance)) >> 1;
    const int first_known = first_kind > 1 ? 1 : 0;
    const int last_known = last_kind > 1 ? 1 : 0;
    const int line = (mean + by_ends) >> (first_known | last_known);
    const int spread = candidates.spread_class();
    const int smooth_class = (1 + std::clamp((smooth + 40) >> 2, 0, 19)) & candidates.any();
    return {static_cast<unsigned>((first_kind * 8 + last_kind) * 6 + std::clamp((mean + 48) >> 4, 0, 5)),
            static_cast<unsigned>((smooth_class * 4 + spread) * 6 + std::clamp((line + 24) >> 3, 0, 5)),
            static_cast<unsigned>((first_known + 2 * last_known) * 4 + spread)};
  }

 private:
  static constexpr int kOwn = PlaceWindow::kStep[kAxis];
  static constexpr int kNext = PlaceWindow::kStep[(kAxis + 1) % 3];
  static constexpr int kLast = PlaceWindow::kStep[(kAxis + 2) % 3];
  static constexpr int kOneOver[5] = {0, 256, 128, 85, 64};

  int seen(int height) const noexcept { return (height ^ outside_) - outside_; }

  struct Height {
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
      return (1 + (spread >= 10 ? 1 : 0) + (spread >= 40 ? 1 : 0)) & (1 - count_) >> 3;
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
  [[gnu::always_inline]] static std::size_t states(const std::uint8_t* node) noexcept {
    if constexpr (kAxis == 0) {
      std::uint32_t four = 0;
      std::memcpy(&four, node - 1, sizeof(four));
      return four * (1U << 24 | 1U << 18 | 1U << 12 | 1U << 6) >> 24;
    }
    return node[-kOwn] + 4U * node[0] + 16U * node[kOwn] + 64U * node[2 * kOwn];
  }

  /// -1 if the place is one.
  static int known(std::int8_t place) noexcept { return (place - PlaceWindow::kNoPlace) >> 8; }

  [[gnu::always_inline]] Height height(int away) const noexcept {
    const Column& column = columns_[states(nodes_ + away)];
    const std::int8_t place = own_[away + column.step * kOwn];
    const int is_known = known(place) & column.cut;
    return {column.height + (place & is_known), is_known};
  }
  static int weighted(const Height& height) noexcept {
    return height.value + ((2 * height.value) & height.known);
  }

  [[gnu::always_inline]] End end(int away) const noexcept {
    const std::uint8_t* const node = nodes_ + away;
    int sum = 0;
    int count = 0;
    int any_cut = 0;
    // `begins`: the edge begins at this end.
    const auto look = [&](const std::int8_t* places, int edge, int other, bool begins) {
      const int cut = -((node[other] + node[0]) == 3 ? 1 : 0);
      const std::int8_t place = places[away + edge];
      const int is_known = known(place) & cut;
      any_cut |= cut;
      count -= is_known;
      sum += (kHalfEdge + (begins ? place : -place)) & is_known;
    };
    look(next_, -kNext, -kNext, false);
    look(next_, 0, kNext, true);
    look(last_, -kLast, -kLast, false);
    look(last_, 0, kLast, true);
    const int if_known = -count >> 3;
    const int distance = sum * kOneOver[count] >> 8;
    const int kind = ((2 + std::min(5, distance * 6 >> 6)) & if_known) | (-any_cut & ~if_known);
    return {distance + (kHalfEdge & ~if_known), kind};
  }

  const std::uint8_t* nodes_;
  const std::int8_t* own_;
  const std::int8_t* next_;
  const std::int8_t* last_;
  int outside_;
  const Column* columns_;
};

}  // namespace deltamesh::grid
