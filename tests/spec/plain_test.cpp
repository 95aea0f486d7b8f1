// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The plain form of a stream: spec/plain.md.
#include "highpass/plain/plain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "base/byte_writer.h"
#include "connectivity/plain/topology.h"
#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "entropy/arrays.h"
#include "format/container.h"
#include "positions/plain.h"
#include "spec/example_lines.h"
#include "support/attribute_coding.h"
#include "support/meshes.h"
#include "support/soups.h"

namespace deltamesh {
namespace {

using test::bytes_of;
using test::Indices;
using test::line_of;

template <class T>
std::string rule_of(const Result<T>& result) {
  return result ? "none" : result.error().rule;
}

TEST(Plain, PLN2PLN3FGRP1TheExamplesTopology) {
  const auto faces = line_of<std::uint32_t>("plain.md", "faces");
  EXPECT_EQ(*read_plain_faces(bytes_of("plain.md", "conn"), 2, 5), faces);
  EXPECT_EQ(write_plain_faces(faces), bytes_of("plain.md", "conn"));
  const auto geometric = line_of<std::uint32_t>("plain.md", "geometric");
  EXPECT_EQ(*read_plain_seams(bytes_of("plain.md", "seam"), 4, 5), geometric);
  EXPECT_EQ(write_plain_seams(geometric), bytes_of("plain.md", "seam"));
  const auto groups = line_of<std::uint32_t>("plain.md", "groups");
  EXPECT_EQ(*read_plain_groups(bytes_of("plain.md", "fgrp"), 2), groups);
  EXPECT_EQ(write_plain_groups(groups), bytes_of("plain.md", "fgrp"));
}

TEST(Plain, PLN4PLN5TheExamplesPositionsAndAnchors) {
  const auto q = line_of<std::int32_t>("plain.md", "q");
  EXPECT_EQ(*read_plain_positions(bytes_of("plain.md", "posn"), 4, {.lattice = {.cells = {4, 4, 3}}}),
            std::vector<float>(q.begin(), q.end()));
  std::vector<Cell> points;
  for (std::size_t i = 0; i < q.size(); i += 3) points.push_back({q[i], q[i + 1], q[i + 2]});
  EXPECT_EQ(write_plain_cells(points), bytes_of("plain.md", "posn"));

  HighpassSymbols symbols;
  ASSERT_TRUE(
      read_plain_anchors(bytes_of("plain.md", "anch"), 4, {.anchor_bits = 12, .anchors = 2}, symbols));
  EXPECT_EQ(symbols.anchors, line_of<std::uint32_t>("plain.md", "anchors"));
  const auto cells = line_of<std::uint32_t>("plain.md", "cells");
  EXPECT_EQ(symbols.cells,
            (std::vector<AnchorCell>{{cells[0], cells[1], cells[2]}, {cells[3], cells[4], cells[5]}}));
  EXPECT_EQ(write_plain_anchors(symbols.anchors, symbols.cells), bytes_of("plain.md", "anch"));
}

TEST(Plain, PLN6TheExamplesAttributes) {
  const auto read = [](const char* name, ComponentType type) {
    return *test::read_plain(bytes_of("plain.md", name),
                             {.kind = AttributeKind::kGeneric, .type = type, .components = 1}, 5);
  };
  EXPECT_EQ(test::numbers<std::uint8_t>(read("exact", ComponentType::kU8)),
            line_of<std::uint8_t>("plain.md", "bytes"));
  EXPECT_EQ(test::numbers<float>(read("steps", ComponentType::kF32)), line_of<float>("plain.md", "values"));
}

TEST(Plain, PLN2RejectsVerticesOutOfRange) {
  EXPECT_EQ(rule_of(read_plain_faces(write_plain_faces(Indices{0, 1, 2}), 1, 3)), "none");
  EXPECT_EQ(rule_of(read_plain_faces(write_plain_faces(Indices{0, 1, 2}), 1, 2)), "PLN-2");
  EXPECT_EQ(rule_of(read_plain_faces(write_plain_faces(Indices{0, 0xffffffff, 2}), 1, 3)), "PLN-2");
  EXPECT_EQ(rule_of(read_plain_faces({}, 0, 3)), "none");
  EXPECT_EQ(rule_of(read_plain_faces(std::vector<std::byte>(1), 0, 3)), "CON-3");
}

TEST(Plain, PLN3RejectsGeometricVerticesOutOfTurn) {
  const auto rule = [](const Indices& geometric, std::uint32_t count) {
    return rule_of(
        read_plain_seams(write_plain_seams(geometric), count, static_cast<std::uint32_t>(geometric.size())));
  };
  EXPECT_EQ(rule({0, 1, 0, 2}, 3), "none");
  EXPECT_EQ(rule({0, 2, 1, 0}, 3), "PLN-3");
  EXPECT_EQ(rule({1, 0, 0}, 2), "PLN-3");
  EXPECT_EQ(rule({0, 1, 0, 1}, 3), "PLN-3");
  EXPECT_EQ(rule({0, 1, 2, 2}, 2), "PLN-3");
  EXPECT_EQ(rule_of(read_plain_seams({}, 3, 3)), "none");
  EXPECT_EQ(rule_of(read_plain_seams({}, 3, 4)), "CON-1");
  EXPECT_EQ(rule_of(read_plain_seams(std::vector<std::byte>(1), 3, 3)), "CON-3");
}

TEST(Plain, PLN5RejectsCoordinatesBeyondTheLattice) {
  const auto rule = [](const Cell& cell) {
    return rule_of(read_plain_positions(write_plain_cells(std::vector<Cell>{cell}), 1,
                                        {.lattice = {.cells = {4, 5, 6}}}));
  };
  EXPECT_EQ(rule({4, 5, 6}), "none");
  EXPECT_EQ(rule({5, 5, 6}), "PLN-5");
  EXPECT_EQ(rule({4, 5, 7}), "PLN-5");
  EXPECT_EQ(rule({4, -1, 6}), "PLN-5");
}

TEST(Plain, GEO1RejectsFloatsThatAreNotFinite) {
  const PredictiveParameters floats{.kind = PositionKind::kFloats, .lattice = {}};
  const auto payload = [](double x) { return write_plain_floats(std::vector<Vec3>{{0, x, 1}}); };
  EXPECT_EQ(rule_of(read_plain_positions(payload(-2.5), 1, floats)), "none");
  EXPECT_EQ(rule_of(read_plain_positions(payload(std::numeric_limits<double>::infinity()), 1, floats)),
            "GEO-1");
}

/// The stream with the chunks of `tag` from `other`.
std::vector<std::byte> with_chunk_of(std::span<const std::byte> stream, std::span<const std::byte> other,
                                     std::uint32_t tag) {
  const auto container = Container::open(stream);
  const auto from = Container::open(other);
  std::vector<CodedChunk> chunks;
  for (const ChunkEntry& entry : container->entries()) {
    const Container& source = entry.tag == tag ? *from : *container;
    const ChunkEntry& taken = entry.tag == tag ? *from->find(tag) : entry;
    const auto bytes = source.coded(taken);
    chunks.push_back({.tag = tag == entry.tag ? tag : entry.tag,
                      .codec = taken.codec,
                      .bytes = {bytes.begin(), bytes.end()},
                      .decoded_bytes = taken.decoded_bytes});
  }
  return write_container(container->header(), chunks);
}

TEST(Plain, PLN1RejectsChunksOfBothForms) {
  Mesh mesh = test::bumpy_grid(9, 9);
  mesh.face_groups.assign(mesh.triangle_count(), 3);
  const auto plain = encode(mesh, {.profile = Profile::kZstd});
  const auto compact = encode(mesh, {.geometry = GeometryCoder::kPredictive});
  ASSERT_TRUE(plain && compact);
  EXPECT_TRUE(decode(with_chunk_of(compact->bytes, compact->bytes, kTagFaceGroups)));
  EXPECT_EQ(rule_of(decode(with_chunk_of(compact->bytes, plain->bytes, kTagFaceGroups))), "PLN-1");
  EXPECT_EQ(rule_of(decode(with_chunk_of(plain->bytes, compact->bytes, kTagFaceGroups))), "PLN-1");
}

TEST(Plain, PLN1AttributesOfCompactStreamsMayBePlain) {
  Mesh mesh = test::bumpy_grid(80, 80);
  Attribute noise{.type = ComponentType::kF64, .components = 1, .name = "noise"};
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const double x = std::sin(static_cast<double>(v));  // more values than a list has
    const auto* bytes = reinterpret_cast<const std::byte*>(&x);
    noise.values.insert(noise.values.end(), bytes, bytes + sizeof(x));
  }
  mesh.attributes.push_back(noise);
  const auto encoded = encode(mesh, {.keep_order = true});
  ASSERT_TRUE(encoded);
  const auto mesh_again = decode(encoded->bytes);
  ASSERT_TRUE(mesh_again) << describe(mesh_again.error());
  EXPECT_EQ(mesh_again->attributes[0].values, noise.values);
}

TEST(Plain, WalksVisitEveryFaceOnce) {
  for (const test::Soup& soup : test::awkward_soups()) {
    Indices faces;
    for (const std::uint32_t corner : walk_faces(soup.triangles, soup.vertex_count))
      faces.push_back(corner / 3);
    std::sort(faces.begin(), faces.end());
    ASSERT_EQ(faces.size(), soup.triangles.size() / 3) << soup.name;
    for (std::uint32_t f = 0; f < faces.size(); ++f) ASSERT_EQ(faces[f], f) << soup.name;
  }
}

TEST(Plain, WalksTakeFewBytesForFacesInAnyOrder) {
  test::Soup grid = test::grid(60, 60, false, false, 0, 1);
  std::uint64_t state = 1;
  for (std::size_t f = grid.triangles.size() / 3; f > 1; --f) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    for (std::size_t k = 0; k < 3; ++k)
      std::swap(grid.triangles[3 * f - 3 + k], grid.triangles[3 * ((state >> 33) % f) + k]);
  }
  Mesh mesh;
  mesh.triangles = grid.triangles;
  for (std::uint32_t v = 0; v < grid.vertex_count; ++v)
    mesh.positions.insert(mesh.positions.end(), {static_cast<float>(v % 61), static_cast<float>(v / 61), 0});
  const auto walked = encode(mesh, {.profile = Profile::kZstd});
  const auto kept = encode(mesh, {.profile = Profile::kZstd, .keep_order = true});
  ASSERT_TRUE(walked && kept);
  EXPECT_LT(2 * walked->bytes.size(), kept->bytes.size());
}

class PlainStreams : public ::testing::TestWithParam<GeometryCoder> {};

TEST_P(PlainStreams, PLN1PLN2PLN3PLN4PLN5PLN6ComeBackInTheInputsOrder) {
  for (const auto& named : test::awkward_meshes()) {
    const EncodeOptions options{
        .geometry = GetParam(), .profile = Profile::kZstd, .keep_order = true, .keep_unreferenced = true};
    const auto encoded = encode(named.mesh, options);
    ASSERT_TRUE(encoded) << named.name << ": " << describe(encoded.error());
    for (const ChunkInfo& chunk : encoded->report.stream.chunks)
      EXPECT_NE(chunk.codec, "compact") << named.name;
    const auto decoded = decode(encoded->bytes);
    ASSERT_TRUE(decoded) << named.name << ": " << describe(decoded.error());
    EXPECT_EQ(decoded->triangles, named.mesh.triangles) << named.name;
    EXPECT_EQ(decoded->vertex_count(), named.mesh.vertex_count()) << named.name;
    EXPECT_EQ(encode(named.mesh, options)->bytes, encoded->bytes) << named.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Coders, PlainStreams,
                         ::testing::Values(GeometryCoder::kAuto, GeometryCoder::kHighpass,
                                           GeometryCoder::kPredictive));

TEST(Plain, LosslessStreamsKeepEveryBit) {
  for (const auto& named : test::awkward_meshes()) {
    const auto encoded =
        encode(named.mesh,
               {.lossless = true, .profile = Profile::kZstd, .keep_order = true, .keep_unreferenced = true});
    ASSERT_TRUE(encoded) << named.name << ": " << describe(encoded.error());
    const auto decoded = decode(encoded->bytes);
    ASSERT_TRUE(decoded) << named.name << ": " << describe(decoded.error());
    EXPECT_EQ(decoded->positions, named.mesh.positions) << named.name;
    for (std::size_t a = 0; a < decoded->attributes.size(); ++a)
      EXPECT_EQ(decoded->attributes[a].values, named.mesh.attributes[a].values) << named.name;
  }
}

}  // namespace
}  // namespace deltamesh
