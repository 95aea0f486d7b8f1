// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What the faces around say of a vertex on a voxel grid: lanes against plain numbers, tables against the
// cube.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <set>
#include <utility>
#include <vector>

#include "format/vertex_positions.h"
#include "positions/grid/coder.h"
#include "positions/grid/faces.h"
#include "positions/grid/view.h"
#include "positions/lattice/lattice.h"
#include "positions/positions.h"
#include "support/graph_mesh.h"
#include "support/peak_memory.h"

namespace deltamesh::voxel_view_test {
namespace {

using voxel::kEdgeNodes;
using voxel::kEdges;
using voxel::kRotated;
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
    const EightShorts both = load_two(a, b);
    EXPECT_EQ(halves_of(both), (std::array<FourShorts, 2>{a, b}));
    EXPECT_EQ(halves_of(load_one(a)), (std::array<FourShorts, 2>{a, FourShorts{}}));
    FourShorts clamped{};
    std::int32_t sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      clamped[i] = std::clamp<std::int16_t>(a[i], -320, 77);
      sum += a[i] * b[i];
    }
    EXPECT_EQ(halves_of(clamp(both, -320, 77))[0], clamped);
    EXPECT_EQ(weigh(both, load_two(b, a)), (std::array{sum, sum}));
    EXPECT_EQ(halves_of(rotate(both))[1], (FourShorts{b[1], b[2], b[0], b[3]}));
    EXPECT_EQ(halves_of(last_of_half(both))[0], (FourShorts{a[3], a[3], a[3], a[3]}));
    const FourInts low = low_ints(both);
    const FourShorts c = {static_cast<std::int16_t>(b[0] / 2), static_cast<std::int16_t>(b[2] / 2),
                          static_cast<std::int16_t>(b[1] / 2), 0};
    const FourShorts d = {static_cast<std::int16_t>(b[1] - (b[1] < 0 ? -1 : 1)), b[3], 255, 0};
    const auto product = [&](std::size_t i, std::size_t j) { return c[i] * d[j] - c[j] * d[i]; };
    const auto products = cross(load_two(c, d), load_two(d, c));
    for (int i = 0; i < 3; ++i) {
      const auto next = static_cast<std::size_t>((i + 1) % 3);
      const auto last = static_cast<std::size_t>((i + 2) % 3);
      EXPECT_EQ(products[0][i], product(next, last));
      EXPECT_EQ(products[1][i], -product(next, last));
    }
    for (int i = 0; i < 4; ++i) {
      EXPECT_EQ(low[i], a[static_cast<std::size_t>(i)]);
    }
  }
}

/// The middle of an edge, of a cube's node.
Nodes middle_of(std::size_t axis, const Nodes& node) {
  Nodes middle = {2 * node[0], 2 * node[1], 2 * node[2]};
  ++middle[axis];
  return middle;
}

TEST(VoxelTables, VOX2The24RotationsOfTheEdges) {
  std::set<std::vector<std::uint8_t>> different;
  for (std::size_t rotation = 0; rotation < voxel::kRotations; ++rotation) {
    std::vector<std::uint8_t> numbers(kRotated[rotation].begin(), kRotated[rotation].begin() + kEdges);
    different.insert(numbers);
    for (std::size_t i = 0; i < kEdges; ++i) {
      EXPECT_EQ(voxel::kBeforeRotation[rotation][kRotated[rotation][i]], i);
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
    EXPECT_EQ(kRotated[rotation][voxel::kNoEdge], voxel::kNoEdge);
  }
  EXPECT_EQ(different.size(), voxel::kRotations);
}

TEST(VoxelTables, VOX3SetsRotateEdgeByEdge) {
  for (std::size_t rotation = 0; rotation < voxel::kRotations; ++rotation) {
    for (unsigned set = 0; set < 1U << kEdges; set += 7) {
      unsigned expected = 0;
      for (unsigned i = 0; i < kEdges; ++i)
        if ((set >> i & 1) != 0) expected |= 1U << kRotated[rotation][i];
      EXPECT_EQ(voxel::rotated_set(rotation, set), expected);
    }
  }
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
      for (const Nodes& node : nodes_within(-kMostApart, kMostApart)) {
        std::set<Nodes> common;
        for (const Nodes& cube : cubes_of(axis2, node))
          if (own.count(cube) != 0) common.insert(cube);
        if (common.size() > 2) common.clear();  // the same edge
        const auto place = static_cast<std::size_t>(125 * static_cast<int>(3 * axis + axis2) + 25 * node[0] +
                                                    5 * node[1] + node[2] + voxel::kPairMiddle);
        const voxel::CubePair& pair = voxel::kPairTable.pairs[voxel::kPairTable.places[place]];
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
          EXPECT_EQ(kRotated[cube.rotation][first], 0);
          constexpr std::array<int, voxel::kPairKinds> kNumbers = {1, 3, 4, 5, 6, 7};
          EXPECT_EQ(kRotated[cube.rotation][second], kNumbers[cube.kind]);
          EXPECT_EQ(cube.others, voxel::kAllEdges & ~(1U << first | 1U << second));
        }
        if (pair.count == 2) {
          EXPECT_EQ(pair.cubes[0].lowest[pair.axis] + kVoxelParts, pair.cubes[1].lowest[pair.axis]);
          EXPECT_EQ(pair.between, pair.cubes[1].lowest[pair.axis]);
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
      EXPECT_EQ(voxel::kEdgesNear[voxel::near_index(axis, node)], expected);
      EXPECT_EQ(voxel::kEdgeAt[voxel::near_index(3, node)], voxel::kNoEdge);
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
      Cell back{};
      store_three(grid.cell_of(FourInts{3, 5, 0, 0}, cut->axis, cut->level), back);
      EXPECT_EQ(back, cell);
      const std::int16_t part = grid.part_of(cut->level);
      EXPECT_EQ(part, 64 * (2 * std::uint64_t{level} + 1) / levels);
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
  std::array<FourInts, 8> nodes{kNowhere, kNowhere, kNowhere, kNowhere,
                                kNowhere, kNowhere, kNowhere, kNowhere};
  std::uint32_t count = 0;

  VoxelPlaces places() const { return {spots, nodes}; }
  VoxelSpot at(const Cell& cell) const {
    const auto cut = grid.cut_of(cell);
    return spot_of(cut->node, cut->axis, grid.part_of(cut->level));
  }
  std::uint32_t add(const Cell& cell) {
    spots[count] = at(cell);
    nodes[count] = four_ints(grid.cut_of(cell)->node);
    return count++;
  }
};

VoxelCorners one_face(std::uint32_t a, std::uint32_t b, std::uint32_t opposite) {
  return {{{a, b, a, b}}, opposite};
}

TEST(VoxelPair, VOX2VOX3VOX6TheFaceAcrossTellsTheCube) {
  // A plane of height 2.5 levels: vertices on upright edges of a row of cubes.
  GridVertices grid;
  const std::uint32_t a = grid.add({8, 8, 3});
  const std::uint32_t b = grid.add({8, 16, 3});
  const std::uint32_t across = grid.add({0, 8, 3});
  const std::uint32_t beyond = grid.add({16, 16, 3});
  // The first vertex is in the higher cube, the second in the lower one.
  const std::array<VoxelCorners, 2> corners = {one_face(a, b, across), one_face(a, b, beyond)};
  const auto cubes = VoxelCubes::find(corners, grid.places());
  ASSERT_TRUE(cubes);
  VoxelPair pair(*cubes, corners, grid.spots);
  for (const std::size_t i : {0, 1}) {
    EXPECT_FALSE(pair.is_open(i));
    const VoxelSpot to_code = grid.at({i == 0 ? 16 : 0, 16, 3});
    const unsigned number = pair.number_of(i, to_code);
    ASSERT_LT(number, kEdges);
    const unsigned edge = pair.edge_of(i, number);
    EXPECT_EQ(edge / 4, 2U);
    EXPECT_EQ(pair.spot_on(i, edge, to_code.at[2]).at, to_code.at);
    EXPECT_EQ(pair.steps_to(i, edge)[0], i == 0 ? 1 : -1);
    EXPECT_EQ(pair.steps_to(i, edge)[1], 1);
    // Level 1 of four: at 48 of 128.
    EXPECT_EQ(pair.plane_on(i, edge), (48 + 16) / 8);
    EXPECT_EQ(pair.mean_on(i, edge), (48 + 16) / 8);
    EXPECT_EQ(pair.number_of(i, grid.spots[i == 0 ? across : beyond]), voxel::kNoEdge);
    // All but those of a and b, which are parallel; the opposite's is parallel to them in the other cube.
    EXPECT_EQ(pair.kind(i), 0U);
    EXPECT_EQ(pair.likely(i), voxel::kAllEdges & ~3U);
    EXPECT_LT(pair.opposite(i), 4U);
  }
}

TEST(VoxelPair, VOX3TheOtherFacesCornersLeaveFewerEdges) {
  GridVertices grid;
  const std::uint32_t a = grid.add({8, 8, 3});
  const std::uint32_t b = grid.add({8, 16, 3});
  const std::uint32_t across = grid.add({0, 8, 3});
  const std::uint32_t last = grid.add({24, 16, 3});
  const std::array<VoxelCorners, 2> corners = {VoxelCorners{{{a, b, b, last}}, across},
                                               one_face(a, b, across)};
  const auto cubes = VoxelCubes::find(corners, grid.places());
  ASSERT_TRUE(cubes);
  const VoxelPair pair(*cubes, corners, grid.spots);
  // Those of the side next to it.
  unsigned expected = 0;
  for (const Cell& cell : {Cell{16, 8, 3}, Cell{16, 16, 3}, Cell{16, 11, 0}, Cell{16, 11, 8}})
    expected |= 1U << pair.number_of(0, grid.at(cell));
  EXPECT_EQ(pair.likely(0), expected);
  EXPECT_EQ(pair.likely(1), voxel::kAllEdges & ~3U);
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
  template <std::size_t K>
  unsigned symbol_and_bits(unsigned, LowBits& low, const Mixture<K>& mixture, SymbolBits&) {
    const unsigned read = symbol(0, mixture);
    if (low.count > 0) low.value = next();
    return read;
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
/// them. The second sequence is of vertices without faces, all alike.
const char* rule_of_third(std::initializer_list<std::uint32_t> said, std::vector<Cell>& cells) {
  const std::vector<std::uint32_t> triangle = {0, 1, 2};
  const VoxelFaces faces(FaceList{triangle, 6});
  // Axis, nodes and level, those of the second sequence's after the first's.
  std::vector<std::uint32_t> script = {2, 2, 2, 0, 1, 2, 2, 2, 0, 1, 2, 0, 2, 0, 2, 2, 0, 0, 0, 1};
  script.insert(script.end(), said.begin(), said.end());
  Script coder(std::move(script));
  VoxelCoder<Script> voxels(coder, faces, {24, 24, 24}, 4);
  cells.assign(6, {});
  EXPECT_EQ(voxels.code_step(0, cells), nullptr);
  EXPECT_EQ(voxels.code_step(1, cells), nullptr);
  EXPECT_EQ(cells[0], (Cell{8, 8, 3}));
  EXPECT_EQ(cells[1], (Cell{8, 16, 5}));
  EXPECT_EQ(cells[3], (Cell{8, 8, 3}));
  EXPECT_EQ(cells[4], (Cell{8, 8, 3}));
  const char* const rule = voxels.code_step(2, cells);
  return rule != nullptr ? rule : "";
}

TEST(VoxelFaces, POSN12TheFirstAndTheLastOfWhatIsKnownByEarlierSteps) {
  const test::GraphMesh mesh = test::sheet(9, 7);
  const auto count = static_cast<std::uint32_t>(mesh.positions.size());
  const VoxelFaces faces(FaceList{mesh.triangles, count});
  const std::uint32_t second = faces.second_sequence();
  EXPECT_EQ(second, 32U);
  EXPECT_EQ(faces.steps(), second);
  const auto step_of = [&](std::uint32_t v) { return v < second ? v : v - second; };
  std::size_t known = 0;
  for (std::uint32_t v = 0; v < count; ++v) {
    VoxelFaces::Star expected = {{count, count, count, count}};
    for (std::size_t f = 0; f < mesh.triangles.size(); f += 3) {
      for (std::size_t c = 0; c < 3; ++c) {
        const std::uint32_t a = mesh.triangles[f + (c + 1) % 3];
        const std::uint32_t b = mesh.triangles[f + (c + 2) % 3];
        if (mesh.triangles[f + c] != v || step_of(a) >= step_of(v) || step_of(b) >= step_of(v)) continue;
        if (expected[0] == count) expected = {{a, b}};
        expected[2] = a;
        expected[3] = b;
        ++known;
      }
    }
    EXPECT_EQ(faces.star(v), expected);
    const Surroundings around = faces.around(v);
    EXPECT_LE(around.known_count, 2U);
    EXPECT_EQ(around.known_count == 0, expected[0] == count);
    for (unsigned i = 0; i < around.known_count; ++i) {
      const KnownFace& face = around.known[i];
      if (face.opposite != kNoVertex) {
        EXPECT_LT(step_of(face.opposite), std::max(step_of(face.a), step_of(face.b)));
      }
    }
  }
  EXPECT_GT(known, mesh.triangles.size() / 4);
}

TEST(VoxelFaces, TakeNoMemoryForVerticesWithoutFaces) {
  // A header may declare many of them, for few bytes.
  constexpr std::uint32_t kDeclared = 1U << 23;
  const std::vector<std::uint32_t> triangles = {0, 1, 2, 2, 1, 3};
  const long before = test::peak_memory();
  const VoxelFaces faces({triangles, kDeclared});
  EXPECT_LT(test::peak_memory() - before, 4096);
  EXPECT_EQ(faces.vertex_count(), kDeclared);
  EXPECT_EQ(faces.around(3).known_count, 1U);
  EXPECT_EQ(faces.around(3).parallelogram_count, 1U);
  for (const std::uint32_t v : {4U, kDeclared / 2, kDeclared - 1, kDeclared}) {
    EXPECT_EQ(faces.star(v)[0], faces.none());
    EXPECT_EQ(faces.around(v).known_count, 0U);
  }
  EXPECT_EQ(faces.across(faces.none(), faces.none()), faces.none());
}

TEST(VoxelFaces, VerticesWithoutFacesMayBeAnywhere) {
  const std::vector<std::uint32_t> triangles = {1, 3, 5, 5, 3, 7};
  const std::vector<std::uint32_t> order = {0, 9, 1, 3, 8, 5, 2, 7, 4, 6};
  std::vector<std::uint32_t> placed(triangles);
  for (std::uint32_t& v : placed)
    v = static_cast<std::uint32_t>(std::find(order.begin(), order.end(), v) - order.begin());
  const VoxelFaces ordered({triangles, 10}, order);
  const VoxelFaces numbered({placed, 10});
  for (std::uint32_t i = 0; i < 10; ++i) {
    EXPECT_EQ(ordered.star(i), numbered.star(i)) << i;
    EXPECT_EQ(ordered.around(i).parallelogram_count, numbered.around(i).parallelogram_count) << i;
  }
  EXPECT_EQ(ordered.star(3), (VoxelFaces::Star{{5, 2, 7, 5}}));  // by steps, in sequences of five
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
    EXPECT_EQ(*back, *to_float_rows(to_positions(cells, parameters.lattice)));
  }
}

TEST(VoxelCoder, VOX1VOX4VOX5VOX6POSN7KnowWhatMayBe) {
  std::vector<Cell> cells;
  EXPECT_STREQ(rule_of_third({14}, cells), "VOX-4");
  EXPECT_STREQ(rule_of_third({15}, cells), "VOX-4");
  EXPECT_STREQ(rule_of_third({13, 13}, cells), "VOX-4");
  EXPECT_STREQ(rule_of_third({12, 4}, cells), "VOX-1");
  EXPECT_STREQ(rule_of_third({12, 0, 100}, cells), "VOX-5");
  EXPECT_STREQ(rule_of_third({0, 4}, cells), "VOX-6");
  for (const bool is_higher : {false, true}) {
    for (std::uint32_t number = 0; number < kEdges; ++number) {
      const char* const rule =
          is_higher ? rule_of_third({13, number, 3}, cells) : rule_of_third({number, 3}, cells);
      EXPECT_STREQ(rule, "");
      // In the cube that was told, at the last level; or, of the face's own edges, in both.
      EXPECT_GE(cells[2][0], is_higher ? 8 : 0);
      EXPECT_LE(cells[2][0], is_higher ? 16 : 8);
    }
  }
}

TEST(VoxelPair, VOX2WithoutAFaceAcrossBothCubesMayBe) {
  GridVertices grid;
  const std::uint32_t a = grid.add({8, 8, 3});
  const std::uint32_t b = grid.add({8, 16, 3});
  const std::array<VoxelCorners, 2> corners = {one_face(a, b, grid.count), one_face(b, a, grid.count)};
  const VoxelSpot to_code = grid.at({16, 16, 3});
  auto cubes = VoxelCubes::find(corners, grid.places());
  ASSERT_TRUE(cubes);
  VoxelPair pair(*cubes, corners, grid.spots);
  for (const std::size_t i : {0, 1}) {
    ASSERT_TRUE(pair.is_open(i));
    EXPECT_EQ(pair.opposite(i), VoxelPair::kOpen);
    EXPECT_TRUE(pair.higher_has(i, to_code));
    EXPECT_FALSE(pair.higher_has(i, grid.at({0, 16, 3})));
    EXPECT_EQ(pair.number_of(i, to_code), voxel::kNoEdge);
  }
  cubes = cubes->with_higher(0);
  pair = VoxelPair(*cubes, corners, grid.spots);
  EXPECT_LT(pair.number_of(0, to_code), kEdges);
  EXPECT_EQ(pair.opposite(0), voxel::kNoEdge);
  EXPECT_TRUE(pair.is_open(1));
}

TEST(VoxelCubes, VOX2FacesWithoutACubeAreNone) {
  GridVertices grid;
  const std::uint32_t a = grid.add({8, 8, 3});
  const std::uint32_t good = grid.add({8, 16, 3});
  const std::uint32_t same = grid.add({8, 8, 5});
  const std::uint32_t far = grid.add({8, 80, 3});
  const std::uint32_t farther = grid.add({8, 16 + 8 * 512, 3});  // the same spot, modulo 2^16
  const VoxelCorners found = one_face(a, good, grid.count);
  for (const std::uint32_t b : {same, far, farther, grid.count}) {
    const VoxelCorners none = one_face(a, b, grid.count);
    EXPECT_FALSE(VoxelCubes::find({none, found}, grid.places()));
    EXPECT_FALSE(VoxelCubes::find({found, none}, grid.places()));
  }
  EXPECT_TRUE(VoxelCubes::find({found, found}, grid.places()));
}

}  // namespace
}  // namespace deltamesh::voxel_view_test
