// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Contexts of levels, which are found without branches, against the sentences of the rule.
#include "grid/place_context.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "grid/bricks.h"
#include "grid/place_window.h"
#include "support/random.h"

namespace deltamesh::grid {
namespace {

/// [GRD-10], word by word.
class PlainContext {
 public:
  PlainContext(const PlaceWindow& window, unsigned axis, int edge) : window_(window), axis_(axis), r_(edge) {}

  PlaceContext context() const {
    const int d1 = PlaceWindow::kStep[(axis_ + 1) % 3];
    const int d2 = PlaceWindow::kStep[(axis_ + 2) % 3];
    const Column west = column(-d1);
    const Column north = column(-d2);
    int sum = 0;
    for (const Column& column : {west, column(d1), north, column(d2)})
      sum += column.is_known ? 3 * column.height : column.height;
    int mean = sum >> 3;

    std::vector<int> candidates;
    const auto add = [&](int height, std::initializer_list<Column> used) {
      if (std::all_of(used.begin(), used.end(), [](const Column& c) { return c.is_known; }))
        candidates.push_back(height);
    };
    const Column far_west = column(-2 * d1);
    const Column far_north = column(-2 * d2);
    const Column between = column(-d1 - d2);
    add(2 * west.height - far_west.height, {west, far_west});
    add(2 * north.height - far_north.height, {north, far_north});
    add(west.height + north.height - between.height, {west, north, between});
    if (d1 < d2) {
      const Column x = column(d1 - d2);
      add(x.height + west.height - north.height, {x, west, north});
    } else {
      const Column x = column(d2 - d1);
      add(x.height + north.height - west.height, {x, west, north});
    }
    int smooth = 0;
    for (const int candidate : candidates) smooth += candidate;
    smooth = smooth * factor(candidates.size()) >> 8;
    int spread = 0;
    if (candidates.size() > 1) {
      const auto [least, largest] = std::minmax_element(candidates.begin(), candidates.end());
      spread = *largest - *least < 10 ? 1 : *largest - *least < 40 ? 2 : 3;
    }

    End first = end(r_);
    End last = end(r_ + PlaceWindow::kStep[axis_]);
    if (state(r_) == PlaceWindow::kOutsideNode) {
      mean = -mean;
      smooth = -smooth;
      std::swap(first, last);
    }
    int line = mean;
    if (first.distance && last.distance) line = (mean + ((*first.distance - *last.distance) >> 1)) >> 1;
    if (first.distance && !last.distance) line = (mean + ((*first.distance - 32) >> 1)) >> 1;
    if (!first.distance && last.distance) line = (mean + ((32 - *last.distance) >> 1)) >> 1;
    const int smooth_class = candidates.empty() ? 0 : 1 + std::clamp((smooth + 40) >> 2, 0, 19);
    const auto model = [](int row, int column) { return static_cast<unsigned>(row * 6 + column); };
    return {.ends = model(8 * first.kind + last.kind, std::clamp((mean + 48) >> 4, 0, 5)),
            .smooth = model(4 * smooth_class + spread, std::clamp((line + 24) >> 3, 0, 5)),
            .weights =
                static_cast<unsigned>(4 * ((first.distance ? 1 : 0) + 2 * (last.distance ? 1 : 0)) + spread)};
  }

 private:
  struct Column {
    int height = 0;
    bool is_known = false;
  };
  struct End {
    std::optional<int> distance;
    int kind = 0;
  };

  static int factor(std::size_t count) { return std::vector<int>{0, 256, 128, 85, 64}[count]; }
  int state(int node) const { return window_.nodes()[node]; }
  std::optional<int> cut(unsigned axis, int edge) const {
    const int place = window_.places(axis)[edge];
    return place == PlaceWindow::kNoPlace ? std::nullopt : std::optional(place);
  }

  Column column(int d) const {
    const int k = PlaceWindow::kStep[axis_];
    const int node = r_ + d;
    const int own = state(r_);
    const int opposite = 3 - own;
    const auto with_cut = [&](int height, int edge) {
      const auto known = cut(axis_, edge);
      return Column{height + known.value_or(0), known.has_value()};
    };
    const int s0 = state(node - k);
    const int s1 = state(node);
    const int s2 = state(node + k);
    const int s3 = state(node + 2 * k);
    if (s1 == own && s2 == opposite) return with_cut(0, node);
    if (s1 == own && s2 == own && s3 == opposite) return with_cut(64, node + k);
    if (s1 == own && s2 == own) return {s3 != PlaceWindow::kUnknown ? 108 : 58, false};
    if (s1 == opposite && s2 == opposite && s0 == own) return with_cut(-64, node - k);
    if (s1 == opposite && s2 == opposite) return {s0 != PlaceWindow::kUnknown ? -108 : -58, false};
    return {};
  }

  End end(int node) const {
    std::vector<int> distances;
    bool any = false;
    for (const unsigned axis : {(axis_ + 1) % 3, (axis_ + 2) % 3}) {
      const int step = PlaceWindow::kStep[axis];
      for (const bool begins : {false, true}) {
        const int other = begins ? node + step : node - step;
        if (state(other) != 3 - state(node)) continue;
        any = true;
        if (const auto known = cut(axis, begins ? node : other))
          distances.push_back(32 + (begins ? *known : -*known));
      }
    }
    if (distances.empty()) return {std::nullopt, any ? 1 : 0};
    int sum = 0;
    for (const int distance : distances) sum += distance;
    const int distance = sum * factor(distances.size()) >> 8;
    return {distance, 2 + std::min(5, 6 * distance / 64)};
  }

  const PlaceWindow& window_;
  unsigned axis_;
  int r_;
};

/// A brick and its margins: `unknown` of 8 nodes are, `smooth` of 8 are as the node before, and so many of 8
/// edges have places.
void fill(Brick& brick, PlaceWindow& window, const Bricks& bricks, unsigned unknown, unsigned smooth,
          unsigned placed, test::RandomBits& random) {
  for (std::uint64_t& row : brick.rows) {
    row = 0;
    std::uint64_t state = 1;
    for (int x = 0; x < kReach; ++x) {
      if (random() % 8 >= smooth) state = random() % 2 == 0 ? 1 : std::uint64_t{1} << Brick::kInsideShift;
      if (random() % 8 >= unknown) row |= state << x;
    }
  }
  window.load(brick, bricks, {});
  const int end = kSide + PlaceWindow::kAround;
  for (unsigned axis = 0; axis < 3; ++axis)
    for (int z = -PlaceWindow::kAround; z < end; ++z)
      for (int y = -PlaceWindow::kAround; y < end; ++y)
        for (int x = -PlaceWindow::kAround; x < end; ++x)
          if (random() % 8 < placed)
            window.set(axis, PlaceWindow::at({x, y, z}),
                       static_cast<std::int8_t>(static_cast<int>(random() % 65) - 32));
}

struct Seen {
  int edges = 0;
  int on_one_side = 0;
};

template <unsigned kAxis>
void compare(const PlaceWindow& window, Seen& seen) {
  for (int z = 0; z < kSide; ++z) {
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        const int edge = PlaceWindow::at({x, y, z});
        const int first = window.nodes()[edge];
        const int last = window.nodes()[edge + PlaceWindow::kStep[kAxis]];
        if (first == PlaceWindow::kUnknown || last == PlaceWindow::kUnknown) continue;
        ++seen.edges;
        seen.on_one_side += first == last ? 1 : 0;
        const PlaceContext fast = PlaceSurroundings<kAxis>(window, edge).context();
        const PlaceContext plain = PlainContext(window, kAxis, edge).context();
        ASSERT_EQ(std::tie(fast.ends, fast.smooth, fast.weights),
                  std::tie(plain.ends, plain.smooth, plain.weights))
            << "axis " << kAxis << " edge " << x << ' ' << y << ' ' << z;
      }
    }
  }
}

TEST(PlaceContext, GRD10IsWhatTheRuleSaysOfAnyEdge) {
  test::RandomBits random(7);
  Seen seen;
  for (const unsigned unknown : {0U, 1U, 4U}) {
    for (const unsigned smooth : {0U, 5U}) {
      for (const unsigned placed : {0U, 2U, 6U, 8U}) {
        Bricks bricks;
        Brick& brick = bricks.get({0, 0, 0});
        PlaceWindow window;
        fill(brick, window, bricks, unknown, smooth, placed, random);
        compare<0>(window, seen);
        compare<1>(window, seen);
        compare<2>(window, seen);
      }
    }
  }
  EXPECT_GT(seen.edges, 100000);
  EXPECT_GT(seen.on_one_side, seen.edges / 4);
}

}  // namespace
}  // namespace deltamesh::grid
