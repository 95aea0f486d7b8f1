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

#include "geometry/vertex_positions.h"
#include "predictive/lattice.h"
#include "predictive/positions.h"
#include "predictive/voxel_coder.h"
#include "support/graph_mesh.h"

namespace deltamesh {
namespace {

using voxel::kEdgeNodes;
using voxel::kEdges;
using voxel::kTurned;
using voxel::Nodes;

class Random {
 public:
  std::int32_t below(std::int32_t range) {
    state_ = state_ * 1664525 + 1013904223;
    return static_cast<std::int32_t>((state_ >> 8) % static_cast<std::uint32_t>(range));
  }

 private:
  std::uint32_t state_ = 1;
};

TEST(VoxelLanes, AreEqualToPlainNumbers) {
  Random random;
  for (int round = 0; round < 3000; ++round) {
    FourShorts a{};
    FourShorts b{};
    for (std::size_t i = 0; i < a.size(); ++i) {
      a[i] = static_cast<std::int16_t>(random.below(65536) - 32768);
      b[i] = static_cast<std::int16_t>(random.below(512) - 256);
    }
    EXPECT_EQ(store(load(a)), a);
    EXPECT_EQ(store(clamp(load(a), -320, 77)), plain::store(plain::clamp(plain::load(a), -320, 77)));
    EXPECT_EQ(store(mul_high(load(a), load(b))),
              plain::store(plain::mul_high(plain::load(a), plain::load(b))));
    EXPECT_EQ(weigh(load(b), a), plain::weigh(plain::load(b), a));
    const FourInts wide = widen(load(a));
    const FourInts product = cross(load(b), load({b[2], b[0], b[1], 0}));
    const FourInts plain_product = plain::cross(load(b), load({b[2], b[0], b[1], 0}));
    for (int i = 0; i < 4; ++i) EXPECT_EQ(wide[i], a[static_cast<std::size_t>(i)]);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(product[i], plain_product[i]);
    FourShorts spot{};
    FourShorts own{};
    for (std::size_t i = 0; i < 3; ++i) {
      spot[i] = static_cast<std::int16_t>(random.below(round % 2 == 0 ? 128 : 5) - (round % 2 == 0 ? 64 : 2));
      own[i] = static_cast<std::int16_t>(-random.below(round % 3 == 0 ? 65 : 2));
    }
    const auto set = static_cast<unsigned>(1 + random.below(4095));
    const NearestEdges edges = nearest_edges(load(spot), load(own), set);
    const NearestEdges plain_edges = plain::nearest_edges(plain::load(spot), plain::load(own), set);
    EXPECT_EQ(edges.nearest, plain_edges.nearest);
    EXPECT_EQ(edges.next, plain_edges.next);
  }
}

/// The middle of an edge, of a cube's node.
Nodes middle_of(std::size_t axis, const Nodes& node) {
  Nodes middle = {2 * node[0], 2 * node[1], 2 * node[2]};
  ++middle[axis];
  return middle;
}

TEST(VoxelTables, VOX2TurnsAreThe24RotationsOfTheEdges) {
  std::set<std::vector<std::uint8_t>> different;
  for (std::size_t turn = 0; turn < voxel::kTurns; ++turn) {
    std::vector<std::uint8_t> numbers(kTurned[turn].begin(), kTurned[turn].begin() + kEdges);
    different.insert(numbers);
    for (std::size_t i = 0; i < kEdges; ++i) {
      EXPECT_EQ(voxel::kBeforeTurn[turn][kTurned[turn][i]], i);
      // Distances between edges stay.
      for (std::size_t j = 0; j < kEdges; ++j) {
        const auto apart = [](std::size_t first, std::size_t second) {
          const Nodes one = middle_of(first / 4, kEdgeNodes[first]);
          const Nodes other = middle_of(second / 4, kEdgeNodes[second]);
          int sum = 0;
          for (std::size_t a = 0; a < 3; ++a) sum += (one[a] - other[a]) * (one[a] - other[a]);
          return sum;
        };
        EXPECT_EQ(apart(i, j), apart(numbers[i], numbers[j]));
      }
    }
    std::sort(numbers.begin(), numbers.end());
    for (std::size_t i = 0; i < kEdges; ++i) EXPECT_EQ(numbers[i], i);
    EXPECT_EQ(kTurned[turn][voxel::kNoEdge], voxel::kNoEdge);
  }
  EXPECT_EQ(different.size(), voxel::kTurns);
}

/// Lowest nodes of the cubes that have an edge.
std::set<Nodes> cubes_of(std::size_t axis, const Nodes& node) {
  std::set<Nodes> cubes;
  for (std::size_t i = 4 * axis; i < 4 * axis + 4; ++i)
    cubes.insert({node[0] - kEdgeNodes[i][0], node[1] - kEdgeNodes[i][1], node[2] - kEdgeNodes[i][2]});
  return cubes;
}

std::vector<Nodes> nodes_within(int below, int above) {
  std::vector<Nodes> nodes;
  for (int x = below; x <= above; ++x)
    for (int y = below; y <= above; ++y)
      for (int z = below; z <= above; ++z) nodes.push_back({x, y, z});
  return nodes;
}

TEST(VoxelTables, VOX2PairsShareTheirCubes) {
  std::size_t count = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto own = cubes_of(axis, {});
    for (std::size_t axis2 = 0; axis2 < 3; ++axis2) {
      for (const Nodes& node : nodes_within(-voxel::kMostApart, voxel::kMostApart)) {
        std::set<Nodes> common;
        for (const Nodes& cube : cubes_of(axis2, node))
          if (own.count(cube) != 0) common.insert(cube);
        if (common.size() > 2) common.clear();  // the same edge
        const auto place = static_cast<std::size_t>(125 * static_cast<int>(axis2) + 25 * node[0] +
                                                    5 * node[1] + node[2] + voxel::kPairMiddle);
        const voxel::CubePair& pair = voxel::kPairTable.pairs[voxel::kPairTable.places[axis][place]];
        ASSERT_EQ(pair.count, common.size());
        count += pair.count > 0 ? 1 : 0;
        for (std::size_t i = 0; i < pair.count; ++i) {
          const voxel::PairCube& cube = pair.cubes[i];
          const Nodes lowest = {cube.lowest[0] / kVoxelParts, cube.lowest[1] / kVoxelParts,
                                cube.lowest[2] / kVoxelParts};
          EXPECT_EQ(common.count(lowest), 1U);
          const unsigned first =
              voxel::kEdgeAt[voxel::near_index(axis, {-lowest[0], -lowest[1], -lowest[2]})];
          const unsigned second = voxel::kEdgeAt[voxel::near_index(
              axis2, {node[0] - lowest[0], node[1] - lowest[1], node[2] - lowest[2]})];
          EXPECT_EQ(kTurned[cube.turn][first], 0);
          constexpr std::array<int, voxel::kPairKinds> kNumbers = {1, 3, 4, 5, 6, 7};
          EXPECT_EQ(kTurned[cube.turn][second], kNumbers[cube.kind]);
          EXPECT_EQ(cube.others, voxel::kAllEdges & ~(1U << first | 1U << second));
        }
        if (pair.count == 2) {
          EXPECT_EQ(pair.cubes[0].lowest[pair.axis] + kVoxelParts, pair.cubes[1].lowest[pair.axis]);
        }
      }
    }
  }
  EXPECT_EQ(count + 1, voxel::kPairs);
}

TEST(VoxelTables, VOX3LikelyEdgesShareACubeWithTheCorner) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const Nodes& node : nodes_within(-voxel::kBelow, voxel::kAbove)) {
      unsigned expected = 0;
      const auto own = cubes_of(axis, node);
      for (unsigned i = 0; i < kEdges; ++i) {
        const bool same = i / 4 == axis && kEdgeNodes[i] == node;
        for (const Nodes& cube : cubes_of(i / 4, kEdgeNodes[i]))
          if (!same && own.count(cube) != 0) expected |= 1U << i;
      }
      EXPECT_EQ(voxel::kEdgesNear[voxel::near_index(axis, node)],
                expected != 0 ? expected : voxel::kAllEdges);
    }
  }
}

TEST(VoxelGrid, VOX6LevelsComeBack) {
  for (const std::uint32_t levels : {1U, 2U, 5U, 16U, 17U, 1000U, 1U << 19}) {
    const VoxelGrid grid(levels);
    const auto voxel = static_cast<std::int32_t>(2 * levels);
    for (const std::uint32_t level : {0U, levels / 2, levels - 1}) {
      const auto signed_level = static_cast<std::int32_t>(level);
      const Cell cell = {3 * voxel, 5 * voxel + 2 * signed_level + 1, 0};
      const auto cut = grid.cut_of(cell);
      ASSERT_TRUE(cut);
      EXPECT_EQ(cut->level, signed_level);
      EXPECT_EQ(cut->axis, 1U);
      EXPECT_EQ(cut->node, (VoxelGrid::Node{3, 5, 0}));
      EXPECT_EQ(grid.cell_of(cut->node, cut->axis, cut->level), cell);
      const std::int16_t part = grid.part_of(cut->level);
      EXPECT_NEAR(part, 128.0 * (level + 0.5) / levels, 1);
      EXPECT_LT(part, kVoxelParts);
      const VoxelSpot spot = spot_of(cut->node, cut->axis, part);
      EXPECT_EQ(spot.at, (FourShorts{3 * 128, static_cast<std::int16_t>(5 * 128 + part), 0, 128}));
      EXPECT_TRUE(spot.on_edge());
    }
    EXPECT_FALSE(grid.cut_of({voxel, voxel, voxel}));
    EXPECT_FALSE(grid.cut_of({1, 1, voxel}));
    EXPECT_FALSE(grid.cut_of({2, 0, 0}));
  }
  EXPECT_FALSE(kOffEdges.on_edge());
}

/// Some vertices of a grid with four levels.
struct GridVertices {
  VoxelGrid grid{4};
  std::array<VoxelSpot, 8> spots{kOffEdges, kOffEdges, kOffEdges, kOffEdges,
                                 kOffEdges, kOffEdges, kOffEdges, kOffEdges};
  std::uint32_t count = 0;

  VoxelSpot at(const Cell& cell) const {
    const auto cut = grid.cut_of(cell);
    return spot_of(cut->node, cut->axis, grid.part_of(cut->level));
  }
  std::uint32_t add(const Cell& cell) {
    spots[count] = at(cell);
    return count++;
  }
};

TEST(VoxelView, VOX2VOX3VOX6TheFaceAcrossTellsTheCube) {
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
    ASSERT_TRUE(view.find(around, grid.spots));
    EXPECT_FALSE(view.is_open());
    view.look(around, grid.spots, kUsualBlends);
    const VoxelSpot to_code = grid.at({is_higher ? 16 : 0, 16, 3});
    const unsigned number = view.number_of(to_code);
    ASSERT_LT(number, kEdges);
    const unsigned edge = view.edge_of(number);
    EXPECT_EQ(edge / 4, 2U);
    EXPECT_EQ(view.spot_on(edge, to_code.at[2]).at, to_code.at);
    EXPECT_EQ(view.corner(), a);
    EXPECT_EQ(view.steps_to(edge)[0], is_higher ? 1 : -1);
    EXPECT_EQ(view.steps_to(edge)[1], 1);
    EXPECT_EQ(view.plane_on(edge), to_code.at[2]);
    EXPECT_EQ(view.mean_on(edge), to_code.at[2]);
    EXPECT_EQ(view.number_of(grid.spots[is_higher ? across : beyond]), voxel::kNoEdge);
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
  EXPECT_EQ(voxels.code_turn(0, cells), nullptr);
  EXPECT_EQ(voxels.code_turn(1, cells), nullptr);
  EXPECT_EQ(cells[0], (Cell{8, 8, 3}));
  EXPECT_EQ(cells[1], (Cell{8, 16, 5}));
  const char* const rule = voxels.code_turn(2, cells);
  return rule != nullptr ? rule : "";
}

TEST(VoxelCoder, POSN12WhatIsKnownHasAnEarlierTurn) {
  const test::GraphMesh mesh = test::sheet(9, 7);
  const auto count = static_cast<std::uint32_t>(mesh.positions.size());
  const FaceList list{mesh.triangles, count};
  const std::uint32_t second = second_walk(list, {.kind = PositionKind::kVoxel, .lattice = {}});
  EXPECT_EQ(second, 32U);
  EXPECT_EQ(second_walk(list, {.kind = PositionKind::kLattice, .lattice = {}}), kNoVertex);
  const KnownFaces faces(list, {}, second);
  EXPECT_EQ(faces.turns(), second);
  const auto turn_of = [&](std::uint32_t v) { return v < second ? v : v - second; };
  std::size_t known = 0;
  for (std::uint32_t v = 0; v < count; ++v) {
    std::size_t expected = 0;
    for (std::size_t f = 0; f < mesh.triangles.size(); f += 3) {
      bool has = false;
      std::size_t earlier = 0;
      for (std::size_t c = f; c < f + 3; ++c) {
        has |= mesh.triangles[c] == v;
        earlier += turn_of(mesh.triangles[c]) < turn_of(v) ? 1 : 0;
      }
      expected += has && earlier == 2 ? 1 : 0;
    }
    const Surroundings around = faces.around(v);
    EXPECT_EQ(around.known_count, std::min<std::size_t>(expected, Surroundings::kMostKnown));
    known += around.known_count;
    for (unsigned i = 0; i < around.known_count; ++i) {
      const KnownFace& face = around.known[i];
      EXPECT_LT(turn_of(face.a), turn_of(v));
      EXPECT_LT(turn_of(face.b), turn_of(v));
      if (face.opposite != kNoVertex) {
        EXPECT_LT(turn_of(face.opposite), std::max(turn_of(face.a), turn_of(face.b)));
      }
    }
  }
  EXPECT_GT(known, mesh.triangles.size() / 4);
}

TEST(VoxelCoder, POSN12AnyNumberOfVerticesComesBack) {
  for (std::uint32_t height = 1; height < 6; ++height) {
    const test::GraphMesh mesh = test::sheet(5, height);
    const FaceList list{mesh.triangles, static_cast<std::uint32_t>(mesh.positions.size())};
    const PredictiveParameters parameters{
        .kind = PositionKind::kVoxel, .lattice = {.cells = {64, 64, 64}}, .levels = 4};
    std::vector<Cell> cells;
    Random random;
    for (const Vec3& position : mesh.positions) {
      const auto x = static_cast<std::int32_t>(8 * position[0]);
      const auto y = static_cast<std::int32_t>(8 * position[1]);
      cells.push_back({x, y, 8 * random.below(2) + 1 + 2 * random.below(4)});
      if (random.below(5) == 0) ++cells.back()[0];
    }
    const auto bytes = write_positions(list, cells, parameters);
    const auto back = read_positions(Payload::compact(bytes), list, parameters, mesh.box);
    ASSERT_TRUE(back);
    EXPECT_EQ(*back, *to_float_rows(to_positions(cells, parameters.lattice), {}));
  }
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
  const VoxelSpot to_code = grid.at({16, 16, 3});
  VoxelView view;
  ASSERT_TRUE(view.find(around, grid.spots));
  ASSERT_TRUE(view.is_open());
  EXPECT_TRUE(view.higher_has(to_code));
  EXPECT_FALSE(view.higher_has(grid.at({0, 16, 3})));
  view.choose(true);
  view.look(around, grid.spots, kUsualBlends);
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
    EXPECT_FALSE(view.find(around, grid.spots));
  }
}

}  // namespace
}  // namespace deltamesh
