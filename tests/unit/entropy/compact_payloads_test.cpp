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
#include <span>
#include <string>

#include "attributes/attribute.h"
#include "base/quick_ratio.h"
#include "base/thread_team.h"
#include "base/try.h"
#include "deltamesh/encode.h"
#include "entropy/compact_reader.h"
#include "entropy/compact_writer.h"
#include "field/field_coder.h"
#include "field/large_field_coder.h"
#include "format/tags.h"
#include "geometry/anchor_list.h"
#include "geometry/delta_symbols.h"
#include "geometry/large_deltas.h"
#include "support/attribute_coding.h"
#include "support/graph_mesh.h"
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
  EXPECT_FALSE(field.code_vertex(0, q, 3));
  const auto read = read_compact_deltas(writer.finish(), mesh.graph);
  ASSERT_FALSE(read);
  EXPECT_STREQ(read.error().rule, "FLD-1");
}

TEST(CompactDeltas, FLD8TakesTwoWalksInTurns) {
  for (const int side : {2, 5, 6}) {
    const auto mesh = test::sheet(side, side);
    const auto n = static_cast<std::uint32_t>(mesh.graph.vertex_count());
    const auto deltas = random_deltas(3 * n, 9, 40);
    const auto at = [&](std::uint32_t v) {
      return FieldNumbers{deltas[v], deltas[n + v], deltas[2 * n + v]};
    };
    CompactWriter writer;
    FieldCoder field(writer, mesh.graph, (n + 1) / 2);
    for (std::uint32_t v = 0; v < n / 2; ++v) {
      FieldNumbers q = at(v);
      FieldNumbers p = at((n + 1) / 2 + v);
      EXPECT_TRUE(field.code_pair(v, (n + 1) / 2 + v, q, p));
    }
    FieldNumbers last = at(n / 2);
    if (n % 2 != 0) {
      EXPECT_TRUE(field.code_vertex(n / 2, last, 3));
    }
    EXPECT_EQ(writer.finish(), write_compact_deltas(deltas, mesh.graph));
  }
}

/// FNV-1a, 64 bits.
std::uint64_t hash_of(std::span<const std::byte> bytes) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const std::byte byte : bytes) hash = (hash ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3;
  return hash;
}

/// No golden stream is as large: a hash keeps the rules.
TEST(CompactDeltas, FLD9FLD11FLD12LargeFieldsKeepTheirBytes) {
  const auto mesh = test::sheet(512, 256);
  const auto n = static_cast<std::uint32_t>(mesh.graph.vertex_count());
  ASSERT_EQ(n, kFewestOfLargeField);
  auto deltas = random_deltas(3 * n, 9, 40);
  for (std::uint32_t v = 0; v < n; ++v) {  // part of them alike, part large, part a multiple of x
    if (v / 5000 % 3 == 0) deltas[v] = 70;
    if (v / 5000 % 4 == 0) deltas[n + v] = 900 + static_cast<std::int32_t>(v % 3);
    if (v / 7000 % 3 == 0) deltas[2 * n + v] = -2 * deltas[v];
  }
  const auto bytes = write_compact_deltas(deltas, mesh.graph);
  EXPECT_EQ(hash_of(bytes), 3583606763406388169U);
  EXPECT_EQ(bytes, write_large_deltas({deltas.data(), n}, mesh.graph));
  EXPECT_TRUE(std::ranges::equal(*read_compact_deltas(bytes, mesh.graph), deltas));
  const ThreadTeam team(2);
  EXPECT_TRUE(std::ranges::equal(*read_compact_deltas(bytes, mesh.graph), deltas));
}

Result<std::vector<std::int32_t>> read_as_large(const Bytes& bytes, const Adjacency& graph) {
  std::vector<std::int32_t> deltas(3 * graph.vertex_count());
  DELTAMESH_CHECK(read_large_deltas(bytes, graph, {deltas.data(), graph.vertex_count()}));
  return deltas;
}

TEST(CompactDeltas, FLD9FLD10PartsOfAnyGraph) {
  for (const auto& mesh : {test::sheet(1, 1), test::sheet(2, 1), test::sheet(9, 7), test::sheet(30, 31),
                           test::fan(1500), test::fragments(), test::GraphMesh{}}) {
    const Adjacency graph =
        build_adjacency(mesh.triangles, static_cast<std::uint32_t>(mesh.positions.size()));
    for (const std::int32_t largest : {0, 1, 100, 3000, 70000, 1 << 30}) {
      auto deltas = random_deltas(3 * graph.vertex_count(), 17, largest);
      if (!deltas.empty() && largest > 0) deltas.front() = -largest;
      const Bytes bytes = write_large_deltas({deltas.data(), graph.vertex_count()}, graph);
      const auto read = read_as_large(bytes, graph);
      ASSERT_TRUE(read) << read.error().message;
      EXPECT_TRUE(std::ranges::equal(*read, deltas));
    }
  }
}

TEST(CompactDeltas, FLD9DamagedPartsAreErrorsOrNumbersInRange) {
  const auto mesh = test::sheet(6, 5);
  const ThreadTeam team(2);
  for (const std::int32_t largest : {3, 1 << 30}) {
    const auto deltas = random_deltas(90, 5, largest);
    const auto read = [&](const Bytes& bytes) {
      const auto back = read_as_large(bytes, mesh.graph);
      if (!back) return false;
      for (const std::int32_t q : *back) EXPECT_LE(std::abs(std::int64_t{q}), kLargestFieldValue);
      return true;
    };
    expect_guarded(write_large_deltas({deltas.data(), 30}, mesh.graph), read, "large deltas");
  }
}

TEST(CompactDeltas, FLD1RejectsLargeNumbersBeyondTheirRange) {
  const auto mesh = test::sheet(2, 2);
  for (const std::size_t place : {0, 7}) {
    std::vector<std::int32_t> deltas(12);
    deltas[place] = -(1 << 30) - 1;
    const auto read = read_as_large(write_large_deltas({deltas.data(), 4}, mesh.graph), mesh.graph);
    ASSERT_FALSE(read);
    EXPECT_STREQ(read.error().rule, "FLD-1");
  }
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
      const auto back = read_anchors(Payload::compact(bytes), static_cast<std::uint32_t>(count));
      if (!back) return false;
      EXPECT_EQ(back->gaps.size(), count);
      EXPECT_EQ(back->steps.size(), 3 * count);
      return true;
    };
    const Bytes bytes = write_compact_anchors(list);
    expect_guarded(bytes, read, "anchors");
    EXPECT_EQ(read_anchors(Payload::compact(bytes), static_cast<std::uint32_t>(count))->gaps, list.gaps);
    EXPECT_EQ(read_anchors(Payload::compact(bytes), static_cast<std::uint32_t>(count))->steps, list.steps);
    EXPECT_EQ(read_anchors(write_plain_anchors(list), static_cast<std::uint32_t>(count))->steps, list.steps);
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

/// Codes the attribute in the order of its rows on the mesh's faces; the compact form equals the plain one.
void expect_forms_agree(const test::GraphMesh& mesh, const Shape& shape) {
  const auto rows = static_cast<std::uint32_t>(mesh.graph.vertex_count());
  std::vector<std::uint32_t> order(rows);
  for (std::uint32_t i = 0; i < rows; ++i) order[i] = rows - 1 - i;
  const Attribute attribute = make_attribute(shape, rows);
  const AttributeSurface surface({}, rows, {}, {}, [&] { return mesh.graph; });
  const auto coded = write_attribute(test::view(attribute), order, {.quality = test::kExactly}, surface, {});
  ASSERT_TRUE(coded && !coded->compact.empty());
  if (!coded->plain.empty()) {
    EXPECT_EQ(read_attribute(coded->plain, coded->descriptor, surface, {}, 1 << 20)->values,
              coded->decoded.values);
  }
  const auto read = [&](const Bytes& bytes) {
    const auto back = read_attribute(Payload::compact(bytes), coded->descriptor, surface, {}, 1 << 20);
    if (!back) return false;
    EXPECT_EQ(back->values.size(), rows * back->components * component_size(back->type));
    return true;
  };
  EXPECT_EQ(read_attribute(Payload::compact(coded->compact), coded->descriptor, surface, {}, 1 << 20)->values,
            coded->decoded.values);
  expect_guarded(coded->compact, read, "attribute");
}

TEST(CompactAttributes, ATTR9EqualsThePlainForm) {
  const auto mesh = test::sheet(7, 6);
  using enum AttributeKind;
  using enum ComponentType;
  for (const Shape& shape : {Shape{kColor, kU8, 3}, Shape{kColor, kU8, 4}, Shape{kColor, kU16, 3},
                             Shape{kGeneric, kU8, 1}, Shape{kGeneric, kI16, 5}})
    expect_forms_agree(mesh, shape);
}

/// Numbers of which the hints know the size; returns the bytes they take.
std::size_t hinted_bytes(const Adjacency& graph, bool with_hints) {
  const std::size_t n = graph.vertex_count();
  test::RandomBits random(21);
  std::vector<std::array<std::int32_t, 3>> numbers(n);
  std::vector<FieldHint> hints(n);
  for (std::size_t v = 0; v < n; ++v) {
    const std::int32_t reach = random() % 2 == 0 ? 1 : 100;
    for (std::size_t a = 0; a < 3; ++a) {
      numbers[v][a] = static_cast<std::int32_t>(random() % (2 * reach + 1)) - reach;
      hints[v].spread[a] = 8 * reach;
      hints[v].offset[a] = static_cast<std::int32_t>(random() % 33) - 16;
    }
  }
  const auto code = [&](auto& coder, auto& q) {
    FieldCoder field(coder, graph);
    for (std::uint32_t v = 0; v < n; ++v)
      if (!field.code_vertex(v, q[v], 3, with_hints ? &hints[v] : nullptr)) return false;
    return true;
  };
  CompactWriter writer;
  EXPECT_TRUE(code(writer, numbers));
  const Bytes bytes = writer.finish();
  CompactReader reader(bytes);
  std::vector<std::array<std::int32_t, 3>> back(n);
  EXPECT_TRUE(code(reader, back));
  EXPECT_TRUE(reader.finish(kTagAttribute));
  EXPECT_EQ(back, numbers);
  return bytes.size();
}

TEST(CompactAttributes, FLD7HintsOfTheSizeArePaidBack) {
  const auto mesh = test::sheet(60, 60);
  EXPECT_LT(10 * hinted_bytes(mesh.graph, true), 9 * hinted_bytes(mesh.graph, false));
}

TEST(CompactAttributes, ATTR2PlainCodingsHaveNoCompactForm) {
  const Attribute attribute = make_attribute({AttributeKind::kGeneric, ComponentType::kF64, 1}, 9);
  const auto coded = test::write_plain(attribute, test::identity(9));
  const AttributeSurface surface({}, 9);
  const auto read = read_attribute(Payload::compact(coded->plain), coded->descriptor, surface, {}, 1 << 20);
  ASSERT_FALSE(read);
  EXPECT_STREQ(read.error().rule, "ATTR-2");
  const std::vector<std::byte> lattice{std::byte{8}};
  EXPECT_STREQ(read_attribute(Payload(lattice), coded->descriptor, surface, {}, 1 << 20).error().rule,
               "ATTR-2");
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
  for (std::uint32_t i = 0; i + 21 < 400; ++i)
    if (i % 20 != 19) mesh.triangles.insert(mesh.triangles.end(), {i, i + 1, i + 20, i + 1, i + 21, i + 20});
  const std::vector<float> normals = [] {
    std::vector<float> all;
    for (int i = 0; i < 400; ++i) all.insert(all.end(), {0.6F, 0, i % 2 == 0 ? 0.8F : -0.8F});
    return all;
  }();
  Attribute attribute{.kind = AttributeKind::kNormal, .components = 3};
  const auto bytes = std::as_bytes(std::span(normals));
  attribute.values.assign(bytes.begin(), bytes.end());
  mesh.attributes.push_back(attribute);
  const auto attribute_chunk = [&](int bits) {
    const auto encoded = encode(mesh, {.bits = bits});
    const auto& chunk = encoded->report.stream.chunks.back();
    EXPECT_STREQ(chunk.tag.data(), "ATTR");
    const auto begin = encoded->bytes.begin() + static_cast<std::ptrdiff_t>(chunk.offset);
    return Bytes(begin, begin + static_cast<std::ptrdiff_t>(chunk.coded_bytes));
  };
  EXPECT_EQ(attribute_chunk(5), attribute_chunk(12));
}

TEST(QuickRatio, CMP9IsNearTheQuotient) {
  test::RandomBits random(1);
  for (int i = 0; i < 10000; ++i) {
    const std::int64_t b = 1 + (static_cast<std::int64_t>(random()) >> (random() % 32));
    const std::int64_t a = static_cast<std::int64_t>(random() % 8000) * b / 1000 - 4 * b;
    const double exact = static_cast<double>(a) / static_cast<double>(b) * 4096;
    EXPECT_NEAR(quick_ratio(a, b), exact, 2 + std::abs(exact) / 400) << a << " / " << b;
  }
  EXPECT_EQ(quick_ratio(1'000'000, 1), 8 * 4096);
  EXPECT_EQ(quick_ratio(-1'000'000, 1), -8 * 4096);
  EXPECT_EQ(quick_ratio(0, 5), 0);
}

}  // namespace
}  // namespace deltamesh
