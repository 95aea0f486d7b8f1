// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What the faces around say of a vertex on a voxel grid: lanes against plain numbers, tables against the
// cube.
#include "predictive/voxel_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <set>
#include <utility>
#include <vector>

#include "predictive/voxel_coder.h"

namespace deltamesh {
namespace {

using voxel::kEdges;
using voxel::kEdgeSteps;
using voxel::kTurned;

class Random {
 public:
  std::int32_t below(std::int32_t range) {
    state_ = state_ * 1664525 + 1013904223;
    return static_cast<std::int32_t>((state_ >> 8) % static_cast<std::uint32_t>(range));
  }

 private:
  std::uint32_t state_ = 1;
};

std::vector<std::int16_t> listed(EightShorts lanes) {
  std::vector<std::int16_t> list;
  for (int i = 0; i < 8; ++i) list.push_back(lanes[i]);
  return list;
}

TEST(VoxelLanes, AreEqualToPlainNumbers) {
  Random random;
  for (int round = 0; round < 2000; ++round) {
    EightShorts a{};
    EightShorts b{};
    for (int i = 0; i < 8; ++i) {
      a[i] = static_cast<std::int16_t>(random.below(65536) - 32768);
      b[i] = static_cast<std::int16_t>(random.below(65536) - 32768);
    }
    EXPECT_EQ(listed(lane_min(a, b)), listed(plain::lane_min(a, b)));
    EXPECT_EQ(listed(lane_max(a, b)), listed(plain::lane_max(a, b)));
    EXPECT_EQ(listed(mul_high(a, b)), listed(plain::mul_high(a, b)));
    EXPECT_EQ(least(a), plain::least(a));
    const FourInts from = {random.below(20), random.below(1 << 29), random.below(9), 5};
    const FourInts to = {random.below(20), random.below(1 << 29), random.below(9), -1};
    const EightShorts steps = steps_between(from, to);
    EXPECT_EQ(listed(steps), listed(plain::steps_between(from, to)));
    EXPECT_EQ(index_of_steps(steps), plain::index_of_steps(steps));
    EXPECT_LT(index_of_steps(steps), kStepIndices);
  }
}

TEST(VoxelTables, TurnsAreThe24RotationsOfTheEdges) {
  std::set<std::vector<std::uint8_t>> different;
  for (std::size_t turn = 0; turn < voxel::kTurns; ++turn) {
    std::vector<std::uint8_t> numbers(kTurned[turn].begin(), kTurned[turn].begin() + kEdges);
    different.insert(numbers);
    for (std::size_t i = 0; i < kEdges; ++i) {
      EXPECT_EQ(voxel::kBeforeTurn[turn][kTurned[turn][i]], i);
      // Distances between edges stay.
      for (std::size_t j = 0; j < kEdges; ++j) {
        int before = 0;
        int after = 0;
        for (std::size_t a = 0; a < 3; ++a) {
          before += (kEdgeSteps[i][a] - kEdgeSteps[j][a]) * (kEdgeSteps[i][a] - kEdgeSteps[j][a]);
          const int apart = kEdgeSteps[numbers[i]][a] - kEdgeSteps[numbers[j]][a];
          after += apart * apart;
        }
        EXPECT_EQ(before, after);
      }
    }
    std::sort(numbers.begin(), numbers.end());
    for (std::size_t i = 0; i < kEdges; ++i) EXPECT_EQ(numbers[i], i);
    EXPECT_EQ(kTurned[turn][voxel::kNoEdge], voxel::kNoEdge);
  }
  EXPECT_EQ(different.size(), voxel::kTurns);
}

/// Centres of the cubes that have an edge.
std::set<std::array<int, 3>> cubes_of(const std::array<int, 3>& edge) {
  std::set<std::array<int, 3>> cubes;
  for (const voxel::Steps& steps : kEdgeSteps) {
    const std::array<int, 3> center = {edge[0] - steps[0], edge[1] - steps[1], edge[2] - steps[2]};
    if (center[0] % 2 != 0 && center[1] % 2 != 0 && center[2] % 2 != 0) cubes.insert(center);
  }
  return cubes;
}

/// Every edge near the middle of a grid, and how many of the three coordinates are odd is one.
template <class Function>
void for_edges_near(const std::array<int, 3>& middle, const Function& visit) {
  for (int x = -3; x <= 3; ++x)
    for (int y = -3; y <= 3; ++y)
      for (int z = -3; z <= 3; ++z) {
        const std::array<int, 3> edge = {middle[0] + x, middle[1] + y, middle[2] + z};
        if (edge[0] % 2 + edge[1] % 2 + edge[2] % 2 == 1) visit(edge);
      }
}

FourInts lanes_of(const std::array<int, 3>& place) { return FourInts{place[0], place[1], place[2], 0}; }

TEST(VoxelTables, VOX2PairsShareTheirCubes) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::array<int, 3> first = {20, 20, 20};
    first[axis] = 21;
    const auto own = cubes_of(first);
    ASSERT_EQ(own.size(), 4U);
    for_edges_near(first, [&](const std::array<int, 3>& second) {
      std::set<std::array<int, 3>> common;
      for (const auto& cube : cubes_of(second))
        if (own.count(cube) != 0) common.insert(cube);
      if (common.size() > 2) common.clear();  // the same edge
      const std::size_t place = index_of_steps(steps_between(lanes_of(first), lanes_of(second)));
      const voxel::CubePair& pair = voxel::kPairTable.pairs[voxel::kPairTable.places[axis][place]];
      ASSERT_EQ(pair.cubes, common.size());
      for (std::size_t i = 0; i < pair.cubes; ++i) {
        const auto& center = pair.centers[i];
        EXPECT_EQ(common.count({first[0] + center[0], first[1] + center[1], first[2] + center[2]}), 1U);
        const auto number = [&](const std::array<int, 3>& edge) {
          const std::size_t at = step_index(edge[0] - first[0] - center[0], edge[1] - first[1] - center[1],
                                            edge[2] - first[2] - center[2]);
          return kTurned[pair.turns[i]][voxel::kEdgeAt[at]];
        };
        EXPECT_EQ(number(first), 0);
        constexpr std::array<int, voxel::kPairKinds> kNumbers = {1, 3, 4, 5, 6, 7};
        EXPECT_EQ(number(second), kNumbers[pair.kinds[i]]);
      }
      if (pair.cubes == 2) {
        EXPECT_EQ(pair.centers[0][pair.axis] + 2, pair.centers[1][pair.axis]);
      }
    });
  }
}

TEST(VoxelTables, VOX3LikelyEdgesShareACubeWithTheCorner) {
  const std::array<int, 3> center = {21, 21, 21};
  for_edges_near(center, [&](const std::array<int, 3>& corner) {
    unsigned expected = 0;
    const auto own = cubes_of(corner);
    for (unsigned i = 0; i < kEdges; ++i) {
      const std::array<int, 3> edge = {center[0] + kEdgeSteps[i][0], center[1] + kEdgeSteps[i][1],
                                       center[2] + kEdgeSteps[i][2]};
      for (const auto& cube : cubes_of(edge))
        if (edge != corner && own.count(cube) != 0) expected |= 1U << i;
    }
    const std::size_t at = index_of_steps(steps_between(lanes_of(center), lanes_of(corner)));
    EXPECT_EQ(voxel::kEdgesNear[at], expected != 0 ? expected : voxel::kAllEdges);
  });
  EXPECT_EQ(voxel::kEdgesNear[step_index(4, 1, 1)], voxel::kAllEdges);
}

TEST(VoxelGrid, VOX6LevelsComeBack) {
  for (const std::uint32_t levels : {1U, 2U, 5U, 16U, 17U, 1000U, 1U << 19}) {
    const VoxelGrid grid(levels);
    const auto voxel = static_cast<std::int32_t>(2 * levels);
    for (const std::int32_t level :
         {0, static_cast<std::int32_t>(levels / 2), static_cast<std::int32_t>(levels - 1)}) {
      const Cell cell = {3 * voxel, 5 * voxel + 2 * level + 1, 0};
      const auto cut = grid.cut_of(cell);
      ASSERT_TRUE(cut);
      EXPECT_EQ(cut->level, level);
      VoxelVertex vertex = cut->vertex;
      EXPECT_EQ(grid.cut(vertex, 1, level), cell);
      EXPECT_TRUE(vertex.on_edge());
      EXPECT_EQ(vertex.axis(), 1U);
      EXPECT_NEAR(vertex.along(), 128.0 * (level + 0.5) / levels, 1);
      EXPECT_EQ(vertex.place[1], 11);
    }
    EXPECT_FALSE(grid.cut_of({voxel, voxel, voxel}));
    EXPECT_FALSE(grid.cut_of({1, 1, voxel}));
    EXPECT_FALSE(grid.cut_of({2, 0, 0}));
  }
}

/// Some vertices of a grid with four levels.
struct GridVertices {
  VoxelGrid grid{4};
  std::array<VoxelVertex, 8> vertices{};
  std::uint32_t count = 0;

  std::uint32_t add(const Cell& cell) {
    vertices[count] = grid.cut_of(cell)->vertex;
    return count++;
  }
};

TEST(VoxelView, VOX2VOX3TheFaceAcrossTellsTheCube) {
  // A plane of height 2.5 levels: vertices on upright edges of a row of cubes.
  GridVertices grid;
  const std::uint32_t a = grid.add({8, 8, 3});
  const std::uint32_t b = grid.add({8, 16, 3});
  const std::uint32_t across = grid.add({0, 8, 3});
  const std::uint32_t beyond = grid.add({16, 16, 3});
  for (const bool is_higher : {true, false}) {
    Surroundings around{};
    around.known[0] = {a, b, is_higher ? across : beyond};
    around.known_count = 1;
    around.parallelogram_count = 1;
    around.neighbor_count = 2;
    around.faces = 6;
    VoxelView view;
    ASSERT_TRUE(view.find(around, grid.vertices));
    EXPECT_FALSE(view.is_open());
    view.look(around, grid.vertices, kUsualBlends);
    const VoxelVertex to_code = grid.grid.cut_of({is_higher ? 16 : 0, 16, 3})->vertex;
    const unsigned number = view.number_of(to_code);
    ASSERT_LT(number, kEdges);
    VoxelVertex back;
    EXPECT_EQ(view.edge_of(number, back), 2U);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(back.place[i], to_code.place[i]);
    EXPECT_EQ(view.plane_along(2, back), to_code.along());
    EXPECT_EQ(view.mean_along(2), to_code.along());
    EXPECT_EQ(view.number_of(grid.vertices[is_higher ? across : beyond]), voxel::kNoEdge);
    EXPECT_EQ(view.likely(), 10U);
  }
}

/// Reads what it is told.
class Script {
 public:
  static constexpr bool kWrites = false;

  explicit Script(std::vector<std::uint32_t> said) : said_(std::move(said)) {}

  template <std::size_t K>
  unsigned symbol(unsigned, const Mixture<K>&) {
    return next();
  }
  bool bit(bool, BitModel&) { return next() != 0; }
  bool decide(bool, std::uint32_t) { return next() != 0; }
  std::uint32_t bits(std::uint32_t, unsigned) { return next(); }
  std::uint32_t number(std::uint32_t, NumberModel&) { return next(); }

 private:
  std::uint32_t next() { return at_ < said_.size() ? said_[at_++] : 0; }

  std::vector<std::uint32_t> said_;
  std::size_t at_ = 0;
};

/// Edges of axis z one voxel apart at levels 1 and 2, then what is said of a vertex that makes a face of
/// them.
const char* rule_of_third(std::initializer_list<std::uint32_t> said, std::vector<Cell>& cells) {
  const std::vector<std::uint32_t> triangle = {0, 1, 2};
  const KnownFaces faces(FaceList{triangle, 3});
  std::vector<std::uint32_t> script = {2, 2, 2, 0, 1, 2, 0, 2, 0, 2};
  script.insert(script.end(), said.begin(), said.end());
  Script coder(std::move(script));
  VoxelCoder<Script> voxels(coder, faces, {24, 24, 24}, 4, kUsualBlends);
  cells.assign(3, {});
  EXPECT_EQ(voxels.code_vertex(0, cells), nullptr);
  EXPECT_EQ(voxels.code_vertex(1, cells), nullptr);
  EXPECT_EQ(cells[0], (Cell{8, 8, 3}));
  EXPECT_EQ(cells[1], (Cell{8, 16, 5}));
  const char* const rule = voxels.code_vertex(2, cells);
  return rule != nullptr ? rule : "";
}

TEST(VoxelCoder, VOX1VOX4VOX5POSN7KnowWhatMayBe) {
  std::vector<Cell> cells;
  EXPECT_STREQ(rule_of_third({1, 13}, cells), "VOX-4");
  EXPECT_STREQ(rule_of_third({1, 15}, cells), "VOX-4");
  EXPECT_STREQ(rule_of_third({1, 12, 4}, cells), "VOX-1");
  EXPECT_STREQ(rule_of_third({1, 12, 0, 100}, cells), "VOX-5");
  for (std::uint32_t higher = 0; higher < 2; ++higher) {
    for (std::uint32_t number = 0; number < kEdges; ++number) {
      EXPECT_STREQ(rule_of_third({higher, number, 3}, cells), "");
      // In the cube that was told, at the last level; or, of the face's own edges, in both.
      EXPECT_GE(cells[2][0], higher == 1 ? 8 : 0);
      EXPECT_LE(cells[2][0], higher == 1 ? 16 : 8);
    }
  }
}

TEST(VoxelView, VOX2WithoutAFaceAcrossABitTells) {
  GridVertices grid;
  Surroundings around{};
  around.known[0] = {grid.add({8, 8, 3}), grid.add({8, 16, 3}), kNoVertex};
  around.known_count = 1;
  around.neighbor_count = 2;
  const VoxelVertex to_code = grid.grid.cut_of({16, 16, 3})->vertex;
  VoxelView view;
  ASSERT_TRUE(view.find(around, grid.vertices));
  ASSERT_TRUE(view.is_open());
  EXPECT_TRUE(view.higher_has(to_code));
  EXPECT_FALSE(view.higher_has(grid.grid.cut_of({0, 16, 3})->vertex));
  view.choose(true);
  view.look(around, grid.vertices, kUsualBlends);
  EXPECT_LT(view.number_of(to_code), kEdges);
  EXPECT_EQ(view.opposite(), voxel::kNoEdge);
}

TEST(VoxelView, VOX2FacesWithoutACubeAreNone) {
  GridVertices grid;
  Surroundings around{};
  around.known_count = 1;
  around.neighbor_count = 2;
  const std::uint32_t a = grid.add({8, 8, 3});
  const std::uint32_t same = grid.add({8, 8, 5});
  const std::uint32_t far = grid.add({8, 80, 3});
  for (const std::uint32_t b : {same, far, grid.count}) {
    around.known[0] = {a, b, kNoVertex};
    VoxelView view;
    EXPECT_FALSE(view.find(around, grid.vertices));
  }
}

}  // namespace
}  // namespace deltamesh
