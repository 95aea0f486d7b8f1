// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The compact forms of DELT, ANCH and ATTR: what was written comes back, nothing else gets through.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

#include "attributes/attribute.h"
#include "deltamesh/encode.h"
#include "entropy/coder/reader.h"
#include "entropy/coder/writer.h"
#include "field/field_coder.h"
#include "format/chunk/tags.h"
#include "highpass/compact.h"
#include "support/attribute_coding.h"
#include "support/attribute_of.h"
#include "support/graph_mesh.h"
#include "support/grid_triangles.h"
#include "support/guarded.h"
#include "support/random.h"

namespace deltamesh {
namespace {

using test::Bytes;
using test::expect_guarded;

std::vector<std::int32_t> random_deltas(std::size_t count, std::uint32_t seed, std::int32_t largest) {
  test::RandomBits random(seed);
  std::vector<std::int32_t> deltas(count);
  for (auto& q : deltas) {
    const auto range = static_cast<std::int64_t>(1) << (random() % 32);
    q = static_cast<std::int32_t>(
        std::min<std::int64_t>(static_cast<std::int64_t>(random()) % range, largest));
    if (random() % 2 == 0) q = -q;
  }
  return deltas;
}

TEST(CompactDeltas, DELT5FLD1ReadsAnyNumbers) {
  for (const auto& mesh : {test::sheet(1, 1), test::sheet(9, 7), test::fan(300), test::GraphMesh{}}) {
    const Adjacency graph =
        build_adjacency(mesh.triangles, static_cast<std::uint32_t>(mesh.positions.size()));
    for (const std::int32_t largest : {0, 1, 100, 70000, 1 << 30}) {
      auto deltas = random_deltas(3 * graph.vertex_count(), 17, largest);
      if (!deltas.empty() && largest > 0) deltas.front() = -largest;
      const Bytes bytes = write_compact_deltas(deltas, graph);
      const auto read = read_compact_deltas(bytes, graph);
      ASSERT_TRUE(read) << read.error().message;
      EXPECT_TRUE(std::ranges::equal(*read, deltas));
      EXPECT_EQ(write_compact_deltas(deltas, graph), bytes);
    }
  }
}

TEST(CompactDeltas, CMP3PrefixesAndFlipsAreErrorsOrNumbersInRange) {
  const auto mesh = test::sheet(6, 5);
  for (const std::int32_t largest : {3, 1 << 30}) {
    const auto deltas = random_deltas(3 * mesh.graph.vertex_count(), 5, largest);
    const auto read = [&](const Bytes& bytes) {
      const auto back = read_compact_deltas(bytes, mesh.graph);
      if (!back) return false;
      EXPECT_EQ(back->size(), deltas.size());
      for (const std::int32_t q : *back) EXPECT_LE(std::abs(std::int64_t{q}), kLargestFieldValue);
      return true;
    };
    expect_guarded(write_compact_deltas(deltas, mesh.graph), read, "deltas");
  }
}

TEST(CompactDeltas, FLD1RejectsNumbersBeyondTheirRange) {
  const auto mesh = test::sheet(2, 2);
  std::vector<std::int32_t> deltas(12);
  deltas[0] = (1 << 30) + 1;
  CompactWriter writer;
  FieldCoder field(writer, mesh.graph);
  std::array<std::int32_t, 3> q = {deltas[0], 0, 0};
  EXPECT_FALSE(field.code_vertex(0, q));
  const auto read = read_compact_deltas(writer.finish(), mesh.graph);
  ASSERT_FALSE(read);
  EXPECT_STREQ(read.error().rule, "FLD-1");
}

/// What spec/compact.md works through: a triangle and a vertex beside it.
TEST(CompactDeltas, FLD13FLD14FLD15WorkedExample) {
  const std::vector<std::uint32_t> triangles = {0, 1, 2, 1, 3, 2};
  const Adjacency graph = build_adjacency(triangles, 4);
  const std::vector<std::int32_t> deltas = {1, 1, 1, 40, 0, -2, -2, -80, 3, 3, 3, 9};
  const Bytes bytes = write_compact_deltas(deltas, graph);
  std::string hex;
  for (const std::byte byte : bytes) {
    hex += "0123456789abcdef"[std::to_integer<unsigned>(byte) >> 4];
    hex += "0123456789abcdef"[std::to_integer<unsigned>(byte) & 15];
  }
  EXPECT_EQ(hex, "7557588af8b4094417e8333511");
  EXPECT_TRUE(std::ranges::equal(*read_compact_deltas(bytes, graph), deltas));
}

/// Vertices alike, close to their peers, with signs that go together, and far from all these.
TEST(CompactDeltas, FLD13FLD14FLD15ReadAllKindsOfNeighborhoods) {
  const auto mesh = test::sheet(64, 50);
  const std::size_t n = mesh.graph.vertex_count();
  auto deltas = random_deltas(3 * n, 9, 40);
  for (std::size_t v = 0; v < n; ++v) {
    if (v / 500 % 3 == 0) deltas[v] = 70;
    if (v / 500 % 4 == 0) deltas[n + v] = 900 + static_cast<std::int32_t>(v % 3);
    if (v / 700 % 3 == 0) deltas[2 * n + v] = -2 * deltas[v];
  }
  EXPECT_TRUE(
      std::ranges::equal(*read_compact_deltas(write_compact_deltas(deltas, mesh.graph), mesh.graph), deltas));
}

TEST(CompactDeltas, SmoothNeighborhoodsPay) {
  const auto mesh = test::sheet(60, 60);
  const std::size_t n = mesh.graph.vertex_count();
  std::vector<std::int32_t> deltas(3 * n);
  test::RandomBits random(2);
  for (std::size_t i = 0; i < n; ++i)
    deltas[2 * n + i] = i < n / 2 ? 0 : static_cast<std::int32_t>(random() % 8);
  EXPECT_LT(write_compact_deltas(deltas, mesh.graph).size() * 8, n * 2);  // 1.5 bits of entropy each
}

TEST(CompactAnchors, ANCH5ReadsWhatWasWritten) {
  for (const std::size_t count : {0, 1, 40}) {
    test::RandomBits random(static_cast<std::uint32_t>(count));
    AnchorList list;
    for (std::size_t i = 0; i < count; ++i) list.gaps.push_back(random() % 300);
    for (std::size_t i = 0; i < 3 * count; ++i) list.steps.push_back(random() >> (random() % 32));
    const auto read = [&](const Bytes& bytes) {
      const auto back = read_anchors(bytes, static_cast<std::uint32_t>(count));
      if (!back) return false;
      EXPECT_EQ(back->gaps.size(), count);
      EXPECT_EQ(back->steps.size(), 3 * count);
      return true;
    };
    const Bytes bytes = write_compact_anchors(list);
    expect_guarded(bytes, read, "anchors");
    EXPECT_EQ(read_anchors(bytes, static_cast<std::uint32_t>(count))->gaps, list.gaps);
    EXPECT_EQ(read_anchors(bytes, static_cast<std::uint32_t>(count))->steps, list.steps);
  }
}

struct Shape {
  AttributeKind kind;
  ComponentType type;
  std::uint8_t components;
};

/// Values that are near to their neighbours' in part, at the ends of their range in part.
Attribute make_attribute(const Shape& shape, std::size_t rows) {
  Attribute attribute{.kind = shape.kind, .type = shape.type, .components = shape.components, .name = "a"};
  attribute.values.resize(rows * shape.components * component_size(shape.type));
  test::RandomBits random(8);
  for (std::size_t i = 0; i < attribute.values.size(); ++i) {
    const std::uint32_t byte = random() % 4 == 0 ? random() % 256 : (i < 90 ? 100 : 250) + random() % 6;
    attribute.values[i] = static_cast<std::byte>(byte);
  }
  if (shape.type != ComponentType::kF32) return attribute;
  for (std::size_t i = 0; i < rows * shape.components; ++i) {
    const float value = shape.kind == AttributeKind::kNormal ? (i % 3 == 2 ? 1.0F : 0.0F)
                                                             : static_cast<float>(random() % 1000) / 999.0F;
    std::memcpy(attribute.values.data() + 4 * i, &value, 4);
  }
  return attribute;
}

/// Codes the attribute in the order of its rows on the mesh's faces.
void expect_round_trip(const test::GraphMesh& mesh, const Shape& shape) {
  const auto rows = static_cast<std::uint32_t>(mesh.graph.vertex_count());
  std::vector<std::uint32_t> order(rows);
  for (std::uint32_t i = 0; i < rows; ++i) order[i] = rows - 1 - i;
  const Attribute attribute = make_attribute(shape, rows);
  const AttributeSurface surface({}, rows, {}, {}, nullptr, mesh.graph);
  const auto coded = write_attribute(test::view(attribute), order, {.quality = test::kExactly}, surface, {});
  ASSERT_TRUE(coded && coded->is_compact);
  const auto read = [&](const Bytes& bytes) {
    const auto back = read_attribute(Payload::compact(bytes), coded->descriptor, surface, {}, 1 << 20);
    if (!back) return false;
    EXPECT_EQ(back->values.size(), rows * back->components * component_size(back->type));
    return true;
  };
  EXPECT_EQ(read_attribute(Payload::compact(coded->payload), coded->descriptor, surface, {}, 1 << 20)->values,
            coded->decoded.values);
  expect_guarded(coded->payload, read, "attribute");
}

TEST(CompactAttributes, ATTR8ExactShapesComeBack) {
  const auto mesh = test::sheet(7, 6);
  using enum AttributeKind;
  using enum ComponentType;
  for (const Shape& shape : {Shape{kColor, kU8, 3}, Shape{kColor, kU8, 4}, Shape{kColor, kU16, 3},
                             Shape{kGeneric, kU8, 1}, Shape{kGeneric, kI16, 5}})
    expect_round_trip(mesh, shape);
}

TEST(CompactAttributes, ATTR2RejectsCodingsOfNoShapeOrNone) {
  const AttributeDescriptor doubles{
      .kind = AttributeKind::kGeneric, .type = ComponentType::kF64, .components = 1};
  const AttributeSurface surface({}, 9);
  for (const unsigned coding : {0U, 3U, 4U, 9U, 11U, 255U}) {
    const std::vector<std::byte> payload{static_cast<std::byte>(coding)};
    const auto read = read_attribute(Payload::compact(payload), doubles, surface, {}, 1 << 20);
    ASSERT_FALSE(read);
    EXPECT_STREQ(read.error().rule, "ATTR-2") << coding;
  }
}

/// What a decoder parses of attributes in a highpass stream must not depend on solved positions, which may
/// differ in their last bits: the same bytes whatever the positions.
TEST(CompactAttributes, ATTR10HighpassAttributesKnowNoPositions) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < 400; ++i) {
    const auto x = static_cast<float>(i % 20);
    const auto y = static_cast<float>(i / 20);
    mesh.positions.insert(mesh.positions.end(), {x, y, std::sin(x) * std::cos(y)});
  }
  mesh.triangles = test::grid_triangles(20, 20);
  const std::vector<float> normals = [] {
    std::vector<float> all;
    for (int i = 0; i < 400; ++i) all.insert(all.end(), {0.6F, 0, i % 2 == 0 ? 0.8F : -0.8F});
    return all;
  }();
  mesh.attributes = {test::attribute_of(AttributeKind::kNormal, ComponentType::kF32, 3, "", normals)};
  const auto attribute_chunk = [&](int bits) {
    const auto encoded = encode(mesh, {.bits = bits});
    const auto& chunk = encoded->report.stream.chunks.back();
    EXPECT_STREQ(chunk.tag.data(), "ATTR");
    const auto begin = encoded->bytes.begin() + static_cast<std::ptrdiff_t>(chunk.offset);
    return Bytes(begin, begin + static_cast<std::ptrdiff_t>(chunk.coded_bytes));
  };
  EXPECT_EQ(attribute_chunk(5), attribute_chunk(12));
}

}  // namespace
}  // namespace deltamesh
