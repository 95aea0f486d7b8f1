// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The worked examples of the specification: their bytes decode to their values, and are what the encoder
// writes.
#include <gtest/gtest.h>
#include <xxhash.h>

#include <cstdint>
#include <vector>

#include "base/byte_writer.h"
#include "connectivity/faces/faces.h"
#include "connectivity/groups/groups.h"
#include "connectivity/order/order.h"
#include "connectivity/seams/seams.h"
#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "deltamesh/version.h"
#include "highpass/compact.h"
#include "positions/positions.h"
#include "spec/example_lines.h"

namespace deltamesh {
namespace {

using test::bytes_of;
using test::line_of;

TEST(Examples, CNT1HDR14DIR2AWholeStream) {
  std::vector<std::byte> bytes;
  for (const unsigned byte : {0x44U, 0x4dU, 0x53U, 0x80U + kFormatDraft})
    bytes.push_back(std::byte{static_cast<std::uint8_t>(byte)});
  for (const char* part : {"header", "chunks"}) {
    const auto more = bytes_of("format.md", part);
    bytes.insert(bytes.end(), more.begin(), more.end());
  }
  ByteWriter stream;
  stream.write_bytes(bytes);
  stream.write(static_cast<std::uint32_t>(XXH3_64bits(bytes.data(), bytes.size())));
  const auto mesh = decode(stream.bytes());
  ASSERT_TRUE(mesh) << describe(mesh.error());
  EXPECT_EQ(mesh->triangles, line_of<std::uint32_t>("format.md", "faces"));
  EXPECT_EQ(mesh->positions, line_of<float>("format.md", "positions"));
  Mesh tetrahedron;
  tetrahedron.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  tetrahedron.triangles = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  const auto encoded = encode(tetrahedron);
  ASSERT_TRUE(encoded);
  EXPECT_EQ(encoded->bytes, stream.take());
}

TEST(Examples, CONN1CONN4CONN5CONN6CONN12CONN13TwoTriangles) {
  const auto compact = bytes_of("conn.md", "compact");
  const auto faces = line_of<std::uint32_t>("conn.md", "faces");
  const auto read = read_connectivity(compact, 4, 2);
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(read->triangles, faces);
  EXPECT_EQ(read->open_edges.size(), 4U);
  EXPECT_EQ(write_connectivity(faces, 4).payload, compact);
}

const std::vector<std::uint32_t> kTwoTriangles = {0, 1, 2, 2, 1, 3};

TEST(Examples, SEAM5SEAM6SEAM7SEAM8ATornEdge) {
  const auto compact = bytes_of("seam.md", "compact");
  const auto faces = line_of<std::uint32_t>("seam.md", "faces");
  const auto read = read_seams(compact, kTwoTriangles, 4, 6);
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(read->triangles, faces);
  EXPECT_EQ(write_seams(kTwoTriangles, 4, faces, {}).payload, compact);
}

TEST(Examples, FGRP1FGRP2FGRP3TwoGroups) {
  const auto compact = bytes_of("fgrp.md", "compact");
  const auto groups = line_of<std::uint32_t>("fgrp.md", "groups");
  EXPECT_EQ(*read_face_groups(compact, kTwoTriangles, 4), groups);
  EXPECT_EQ(write_face_groups(groups, kTwoTriangles, 4), compact);
}

TEST(Examples, ORDR2ORDR3ORDR4ORDR5ORDR6TwoTriangles) {
  const auto compact = bytes_of("ordr.md", "compact");
  const MeshOrder order{.vertices = line_of<std::uint32_t>("ordr.md", "vertices"),
                        .faces = line_of<std::uint32_t>("ordr.md", "faces"),
                        .rotation = line_of<std::uint8_t>("ordr.md", "rotations")};
  const auto read = read_order(compact, kTwoTriangles, 4);
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(read->vertices, order.vertices);
  EXPECT_EQ(read->faces, order.faces);
  EXPECT_EQ(read->rotation, order.rotation);
  EXPECT_EQ(write_order(order, kTwoTriangles), compact);
}

TEST(Examples, ANCH1ANCH3ANCH4ANCH5TwoAnchors) {
  const auto compact = bytes_of("anch.md", "compact");
  const AnchorList list{.gaps = line_of<std::uint32_t>("anch.md", "gaps"),
                        .steps = line_of<std::uint32_t>("anch.md", "cells")};
  const auto read = read_anchors(compact, 2);
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(read->gaps, list.gaps);
  EXPECT_EQ(read->steps, list.steps);
  EXPECT_EQ(write_compact_anchors(list), compact);
}

TEST(Examples, POSN1POSN2POSN3POSN4POSN5POSN6POSN8FourPoints) {
  const auto payload = bytes_of("posn.md", "payload");
  const auto q = line_of<std::int32_t>("posn.md", "q");
  const std::vector<std::uint32_t> triangles = {0, 1, 2, 2, 1, 3};
  const PredictiveParameters parameters{.kind = PositionKind::kLattice, .lattice = {.cells = {4, 4, 3}}};
  const auto read = read_positions(payload, {triangles, 4}, parameters, {});
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, std::vector<float>(q.begin(), q.end()));
  std::vector<Cell> cells;
  for (std::size_t v = 0; v + 2 < q.size(); v += 3) cells.push_back({q[v], q[v + 1], q[v + 2]});
  EXPECT_EQ(write_positions({triangles, 4}, cells, parameters), payload);
}

}  // namespace
}  // namespace deltamesh
