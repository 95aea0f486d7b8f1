// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The worked examples of positions: deltas and anchors, grids, floats. Their bytes decode to
// their values, and are what the encoder writes.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "grid/grid.h"
#include "highpass/compact.h"
#include "highpass/highpass.h"
#include "positions/positions.h"
#include "spec/example_lines.h"
#include "topology/adjacency.h"

namespace deltamesh {
namespace {

using test::bytes_of;
using test::line_of;

TEST(GeometryExamples, DELT2DELT4DELT5AStripOfEightVertices) {
  const auto compact = bytes_of("delt.md", "compact");
  const auto anchors = bytes_of("delt.md", "anchors");
  const auto q = line_of<std::int32_t>("delt.md", "q");
  const auto faces = line_of<std::uint32_t>("delt.md", "faces");
  const auto positions = line_of<double>("delt.md", "positions");
  const Adjacency graph = build_adjacency(faces, 8);
  EXPECT_EQ(write_compact_deltas(q, graph), compact);
  const Box box{.min = {0, 0, 0}, .max = {3, 1, 1.5}};
  const HighpassParameters parameters{
      .step = 0.25, .shift = {.one = 32, .more = 16}, .anchor_bits = 4, .anchors = 2};
  const auto read = read_highpass(Payload::compact(compact), Payload(anchors), graph, find_components(graph),
                                  box, parameters);
  ASSERT_TRUE(read) << describe(read.error());
  for (std::size_t i = 0; i < 24; ++i) EXPECT_NEAR((*read)[i / 3][i % 3], positions[i], 1e-5);
}

TEST(GeometryExamples, GRD11GRD12ACornerInsideAndAFaceBesideIt) {
  const auto faces = line_of<std::uint32_t>("grid.md", "faces");
  const auto q = line_of<std::int32_t>("grid.md", "q");
  const GridPayloads payloads{.surface = bytes_of("grid.md", "payload"),
                              .rest_faces = bytes_of("grid.md", "conn")};
  const PredictiveParameters parameters{
      .kind = PositionKind::kVoxel, .lattice = {.cells = {8, 8, 8}}, .levels = 2};
  const auto read = read_grid(chunks_of(payloads), parameters, 8, 10);
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(read->triangles, faces);
  EXPECT_EQ(read->positions, std::vector<float>(q.begin(), q.end()));
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < q.size(); i += 3) cells.push_back({q[i], q[i + 1], q[i + 2]});
  const auto written = write_grid(faces, cells, parameters);
  ASSERT_TRUE(written);
  EXPECT_EQ(written->payloads.surface, payloads.surface);
  EXPECT_EQ(written->payloads.rest_faces, payloads.rest_faces);
}

TEST(GeometryExamples, FLT1FLT2FLT3FLT4FourPoints) {
  const auto payload = bytes_of("posn_floats.md", "payload");
  const auto values = line_of<float>("posn_floats.md", "values");
  const std::vector<std::uint32_t> faces = {0, 1, 2, 2, 1, 3};
  std::vector<Vec3> positions;
  for (std::size_t i = 0; i < values.size(); i += 3)
    positions.push_back({values[i], values[i + 1], values[i + 2]});
  const Box box{.min = {0, 0, 0}, .max = {1, positions[3][1], 0.5}};
  PredictiveParameters parameters;
  parameters.kind = PositionKind::kFloats;
  const auto read = read_positions(payload, {faces, 4}, parameters, box);
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(*read, values);
  EXPECT_EQ(write_floats({faces, 4}, positions, box), payload);
}

}  // namespace
}  // namespace deltamesh
