// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Cubes, the loops around their corners, and the windows around them, by the letter.
#include "grid/cube/cube.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <utility>
#include <vector>

#include "entropy/coder/counted_bit.h"
#include "field/cube_cases.h"
#include "grid/bricks.h"
#include "grid/cube/loops.h"
#include "grid/pattern_coder.h"
#include "grid/window.h"
#include "support/random.h"

namespace deltamesh::grid {
namespace {

TEST(Cube, EdgesAreBetweenCorners) {
  for (unsigned edge = 0; edge < kEdges; ++edge) {
    EXPECT_EQ(last_corner(edge) - first_corner(edge), 1U << edge / 4);
    EXPECT_EQ(edge_between(first_corner(edge), last_corner(edge)), edge);
    EXPECT_EQ(edge_between(last_corner(edge), first_corner(edge)), edge);
  }
}

TEST(Cube, GRD6LoopsPassEveryCutEdgeOnce) {
  for (Signs signs = 0; signs < 256; ++signs) {
    std::set<unsigned> cut;
    for (unsigned edge = 0; edge < kEdges; ++edge)
      if ((signs >> first_corner(edge) & 1) != (signs >> last_corner(edge) & 1)) cut.insert(edge);
    const unsigned ambiguous = ambiguous_faces(signs);
    for (unsigned joins = ambiguous;; joins = (joins - 1) & ambiguous) {
      const Loops loops(signs, joins);
      std::set<unsigned> passed;
      for (unsigned i = 0; i < loops.count(); ++i) {
        EXPECT_GE(loops[i].size(), 3U);
        for (const unsigned edge : loops[i]) EXPECT_TRUE(passed.insert(edge).second);
      }
      EXPECT_EQ(passed, cut);
      if (joins == 0) break;
    }
  }
}

TEST(Cube, ATableOfMarchingCubesFillsLoops) {
  // The scenes' table has a bit for corners that are inside.
  for (unsigned inside = 1; inside < 255; ++inside) {
    Pattern pattern;
    for (const auto& triangle : scenes::cube_cases()[inside]) {
      std::array<std::uint8_t, 3> edges{};
      for (std::size_t c = 0; c < 3; ++c) {
        const auto& edge = scenes::cube_edges()[triangle[c]];
        edges[c] = static_cast<std::uint8_t>(edge_between(edge.low, edge.low | 1U << edge.axis));
      }
      pattern.add(edges);
    }
    pattern.sort();
    EXPECT_TRUE(find_joins(~inside & 255, pattern)) << inside;
  }
}

TEST(Window, GRD4SeesNodesOfAllBricks) {
  Bricks bricks;
  test::RandomBits random(2);
  const auto state = [](int x, int y, int z) { return (x * 7 + y * 5 + z * 3 + x * y * z) % 3; };
  bricks.get({0, 0, 0});
  // Each node once, from some brick that it is a corner of a cube of.
  std::vector<Spot> nodes;
  for (int z = 0; z < 40; ++z)
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x)
        if (state(x, y, z) != 0) nodes.push_back({x, y, z});
  for (std::size_t i = nodes.size(); i > 1; --i) std::swap(nodes[i - 1], nodes[random() % i]);
  for (const Spot& node : nodes) {
    Bricks::Place at{};
    Spot spot{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int back = node[axis] % 16 == 0 && node[axis] > 0 && random() % 2 == 0 ? 1 : 0;
      at[axis] = node[axis] / 16 - back;
      spot[axis] = node[axis] - 16 * at[axis];
    }
    // As a corner of the cube that begins there, or of the last one of the brick before.
    unsigned corner = 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
      if (spot[axis] < kSide) continue;
      spot[axis] = kSide - 1;
      corner |= 1U << axis;
    }
    const auto own = static_cast<Signs>(1U << corner);
    const bool is_outside = state(node[0], node[1], node[2]) == 1;
    bricks.set_corners(bricks.get(at), place_of(spot), is_outside ? own : Signs{},
                       is_outside ? Signs{} : own);
  }
  for (int z = 1; z < 36; ++z) {
    for (int y = 1; y < 36; ++y) {
      for (int x = 1; x < 36; ++x) {
        const Brick& brick = bricks.get({x / 16, y / 16, z / 16});
        const unsigned place = place_of({x % 16, y % 16, z % 16});
        const Window window(brick, place);
        const Corners corners(brick, place);
        for (unsigned corner = 0; corner < kCorners; ++corner) {
          const Spot at = {x + static_cast<int>(corner & 1), y + static_cast<int>(corner >> 1 & 1),
                           z + static_cast<int>(corner >> 2)};
          const int own = state(at[0], at[1], at[2]);
          ASSERT_EQ(corners.outside >> corner & 1, own == 1 ? 1U : 0U);
          ASSERT_EQ(corners.inside >> corner & 1, own == 2 ? 1U : 0U);
          int more = 0;
          for (int i = 0; i < 27; ++i) {
            const Spot other = {at[0] + i % 3 - 1, at[1] + i / 3 % 3 - 1, at[2] + i / 9 - 1};
            const bool is_own = (other[0] == x || other[0] == x + 1) &&
                                (other[1] == y || other[1] == y + 1) && (other[2] == z || other[2] == z + 1);
            const int of_other = state(other[0], other[1], other[2]);
            if (!is_own) more += of_other == 1 ? 1 : (of_other == 2 ? -1 : 0);
          }
          ASSERT_EQ(window.majority(corner), more > 0 ? 2U : (more == 0 ? 1U : 0U));
        }
      }
    }
  }
}

TEST(CountedBit, GRD2FollowsTheRule) {
  CountedBit bit;
  std::int32_t estimate = 32768;
  test::RandomBits random(9);
  for (int n = 0; n < 300; ++n) {
    EXPECT_EQ(bit.probability(), static_cast<std::uint32_t>(std::clamp(estimate >> 1, 32, 32736)));
    const bool value = n > 150 || random() % 4 == 0;
    const int rate = n < 1 ? 1 : n < 3 ? 2 : n < 7 ? 3 : n < 15 ? 4 : n < 31 ? 5 : n < 80 ? 6 : 7;
    bit.learn(value);
    estimate += ((value ? 65535 : 0) - estimate) >> rate;
  }
}

}  // namespace
}  // namespace deltamesh::grid
