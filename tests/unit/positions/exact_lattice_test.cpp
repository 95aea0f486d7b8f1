// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "positions/lattice/exact_lattice.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <vector>

#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "entropy/coder/reader.h"
#include "entropy/coder/writer.h"
#include "format/vertex_positions.h"
#include "positions/lattice/lattice.h"
#include "positions/positions.h"
#include "support/graph_mesh.h"
#include "support/meshes.h"

namespace deltamesh {
namespace {

Box box_of(const std::vector<Vec3>& positions) { return test::finish({.positions = positions}).box; }

/// Floats of decimals.
std::vector<Vec3> decimals(double unit, int multiple) {
  std::vector<Vec3> positions;
  std::uint32_t state = 7;
  const auto next = [&] {
    state = state * 1664525 + 1013904223;
    return static_cast<double>(
        static_cast<float>((static_cast<int>(state >> 12) - 400'000) * multiple / unit));
  };
  for (int i = 0; i < 1000; ++i) positions.push_back({next(), next(), next()});
  return positions;
}

void expect_exact(const std::vector<Vec3>& positions, double step) {
  const auto lattice = find_exact_lattice(positions, box_of(positions));
  ASSERT_TRUE(lattice) << step;
  EXPECT_NEAR(lattice->step[0], step, 1e-12 * step);
  const auto back = to_positions(to_cells(positions, *lattice), *lattice);
  for (std::size_t v = 0; v < positions.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_EQ(static_cast<float>(back[v][axis]), static_cast<float>(positions[v][axis]));
}

TEST(ExactLattice, DecimalsAndMultiplesAreFound) {
  expect_exact(decimals(1, 1), 1);
  expect_exact(decimals(1, 30), 30);
  expect_exact(decimals(100, 1), 0.01);
  expect_exact(decimals(100, 25), 0.25);
  expect_exact(decimals(1e6, 1), 1e-6);
}

TEST(ExactLattice, OtherFloatsHaveNone) {
  std::vector<Vec3> positions = decimals(1000, 1);
  for (std::size_t v = 0; v < positions.size(); v += 4)
    positions[v][1] = static_cast<double>(static_cast<float>(std::ldexp(1.1, -static_cast<int>(v % 97))));
  EXPECT_FALSE(find_exact_lattice(positions, box_of(positions)));
  positions = {{0, 0, 0}, {3e38, 1, 1}, {-3e38, 1e-38, 1}};
  EXPECT_FALSE(find_exact_lattice(positions, box_of(positions)));
  EXPECT_FALSE(find_exact_lattice({}, {}));
}

TEST(ExactLattice, POSN11FewOthersArePatched) {
  std::vector<Vec3> positions = decimals(1000, 1);
  positions[3][0] = -0.0;
  positions[500][1] = static_cast<double>(std::nextafter(static_cast<float>(positions[500][1]), 1e9F));
  positions[999][2] = -static_cast<double>(1e-30F);
  const auto lattice = find_exact_lattice(positions, box_of(positions));
  ASSERT_TRUE(lattice);
  const auto cells = to_cells(positions, *lattice);
  const auto replacements = find_replacements(positions, to_positions(cells, *lattice));
  ASSERT_EQ(replacements.size(), 3U);
  EXPECT_EQ(replacements[1].coordinate, 1501U);
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t v = 0; v + 2 < positions.size(); ++v)
    triangles.insert(triangles.end(), {v, v + 1, v + 2});
  const FaceList faces{triangles, 1000};
  for (const CodingOrder coding_order : {CodingOrder::kAsDecoded, CodingOrder::kBroad, CodingOrder::kDeep}) {
    const PredictiveParameters parameters{.lattice = *lattice};
    const auto bytes =
        write_positions(faces, cells, parameters, {.coding_order = coding_order}, replacements);
    const auto back = read_positions(Payload::compact(bytes), faces, parameters, box_of(positions));
    ASSERT_TRUE(back) << back.error().message;
    const auto rows = to_float_rows(positions);
    EXPECT_EQ(std::memcmp(back->data(), rows->data(), rows->size() * sizeof(float)), 0);
  }
}

TEST(ExactLattice, POSN11RefusesWhatIsNotThere) {
  const auto refuses = [](std::uint32_t count, std::uint32_t gap, float value) {
    CompactWriter writer;
    NumberModel counts;
    NumberModel gaps;
    writer.number(count, counts);
    writer.number(gap, gaps);
    writer.bits(std::bit_cast<std::uint32_t>(value), 32);
    const auto bytes = writer.finish();
    CompactReader reader(bytes);
    std::vector<Replacement> replacements;
    return !code_replacements(reader, replacements, 30);
  };
  EXPECT_FALSE(refuses(1, 29, 1.5F));
  EXPECT_TRUE(refuses(31, 0, 1.5F));
  EXPECT_TRUE(refuses(1, 30, 1.5F));
  EXPECT_TRUE(refuses(1, 0, HUGE_VALF));
}

TEST(ExactLattice, FlatAxesHaveOnePoint) {
  const std::vector<Vec3> positions = {{1, 2, 5}, {3, 2, 5}, {4, 2, 5}};
  const auto lattice = find_exact_lattice(positions, box_of(positions));
  ASSERT_TRUE(lattice);
  EXPECT_EQ(lattice->cells[0], 3U);
  EXPECT_EQ(lattice->cells[1], 0U);
  EXPECT_EQ(lattice->at(2, 0), 5);
}

TEST(ExactLattice, LosslessStreamsOfDecimalsAreSmaller) {
  Mesh decimal = test::bumpy_grid(60, 50);
  std::uint32_t state = 1;
  for (float& x : decimal.positions) {
    const double jitter = ((state = state * 1664525 + 1013904223) >> 24) / 256.0;
    x = static_cast<float>(std::round(1000 * (x + jitter)) / 1000);
  }
  Mesh other = decimal;
  for (std::size_t i = 0; i < other.positions.size(); i += 5)
    other.positions[i] = std::nextafter(other.positions[i], 100.0F);
  const auto smaller = encode(decimal, {.lossless = true, .keep_order = true});
  const auto larger = encode(other, {.lossless = true, .keep_order = true});
  ASSERT_TRUE(smaller && larger);
  EXPECT_LT(smaller->bytes.size(), larger->bytes.size());
  EXPECT_EQ(smaller->report.stream.quality.max_error, 0);
  const auto back = decode(smaller->bytes);
  ASSERT_TRUE(back);
  EXPECT_EQ(std::memcmp(back->positions.data(), decimal.positions.data(), 4 * decimal.positions.size()), 0);
}

}  // namespace
}  // namespace deltamesh
