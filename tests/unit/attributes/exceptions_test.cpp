// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/exceptions/exceptions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "attributes/attribute.h"
#include "base/numbers/short_float.h"
#include "deltamesh/encode.h"
#include "round_trip.h"
#include "support/attribute_coding.h"
#include "support/grid_triangles.h"
#include "support/random.h"

namespace deltamesh::exceptions_test {
namespace {

using test::grid_triangles;
using test::identity;
using test::numbers;

constexpr std::uint32_t kSide = 30;
constexpr std::uint32_t kVertices = kSide * kSide;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Of a wavy sheet over a grid.
struct Sheet {
  std::vector<std::uint32_t> triangles = grid_triangles(kSide, kSide);
  std::vector<float> positions;
  std::vector<float> normals;   ///< of the length 3
  std::vector<float> tangents;  ///< of the length 0.5
  std::vector<float> uvs;
  std::vector<float> colors;
  std::vector<float> heights;
  std::vector<float> weights;

  Sheet() {
    for (std::uint32_t v = 0; v < kVertices; ++v) {
      const auto x = static_cast<float>(v % kSide);
      const auto y = static_cast<float>(v / kSide);
      const float slope = 0.4F * std::cos(0.4F * x);
      const float size = std::sqrt(1 + slope * slope);
      const float height = std::sin(0.4F * x);
      positions.insert(positions.end(), {x, y, height});
      normals.insert(normals.end(), {-3 * slope / size, 0, 3 / size});
      tangents.insert(tangents.end(), {0.5F / size, 0, 0.5F * slope / size, 1});
      uvs.insert(uvs.end(), {x / kSide, y / kSide});
      colors.insert(colors.end(), {x / kSide, y / kSide, 0.5F});
      heights.push_back(100 + 20 * height + 0.01F * x * y);
      weights.insert(weights.end(), {1 - x / kSide, x / kSide, 0, 0});
    }
  }
  AttributeSurface surface() const { return {triangles, kVertices, {}, positions}; }
};

struct Case {
  AttributeKind kind;
  std::uint8_t components;
  AttributeCoding coding;
  std::vector<float> values;
};

std::vector<Case> cases() {
  const Sheet sheet;
  return {{AttributeKind::kNormal, 3, AttributeCoding::kSurfaceNormals, sheet.normals},
          {AttributeKind::kTangent, 4, AttributeCoding::kSurfaceTangents, sheet.tangents},
          {AttributeKind::kUv, 2, AttributeCoding::kSurfaceUvs, sheet.uvs},
          {AttributeKind::kColor, 3, AttributeCoding::kSurfaceColors, sheet.colors},
          {AttributeKind::kWeights, 4, AttributeCoding::kWeights, sheet.weights},
          {AttributeKind::kGeneric, 1, AttributeCoding::kLattice, sheet.heights}};
}

AttributeQuality bounds() {
  return {.uv_error = 0.001, .color_error = 1, .named = {{.name = "a", .error = 0.05}}};
}

Attribute make(const Case& c) {
  return test::attribute_of(c.kind, ComponentType::kF32, c.components, "a", c.values);
}

CodedAttribute code(const Attribute& a, const AttributeQuality& quality,
                    std::span<const Attribute> others = {}) {
  const Sheet sheet;
  auto coded = test::code(a, quality, sheet.surface(), others);
  EXPECT_TRUE(coded.is_compact);
  return coded;
}

int coding_byte(const CodedAttribute& coded) { return std::to_integer<int>(coded.payload.at(0)); }

void expect_bits(const CodedAttribute& coded, const std::vector<float>& source, std::size_t components,
                 std::size_t vertex) {
  const auto back = numbers<float>(coded.decoded);
  EXPECT_EQ(std::memcmp(&back[vertex * components], &source[vertex * components], 4 * components), 0);
}

TEST(Exceptions, ATTR12OneBadValueCostsOneValue) {
  for (Case c : cases()) {
    SCOPED_TRACE(static_cast<int>(c.kind));
    const CodedAttribute good = code(make(c), bounds());
    ASSERT_EQ(coding_byte(good), static_cast<int>(c.coding));
    c.values[100 * c.components] = kNan;
    c.values[500 * c.components + c.components - 1] = -kInfinity;
    const CodedAttribute coded = code(make(c), bounds());
    EXPECT_EQ(coding_byte(coded), static_cast<int>(c.coding) | kExceptionsFlag);
    EXPECT_LT(coded.payload.size(), good.payload.size() + 8 * c.components + 60);
    EXPECT_GT(coded.descriptor.error, 0);
    EXPECT_LE(coded.descriptor.error, 1.01 * good.descriptor.error + 1e-6);
    expect_bits(coded, c.values, c.components, 100);
    expect_bits(coded, c.values, c.components, 500);
  }
}

TEST(Exceptions, ATTR12OneHugeTextureCoordinateCostsOneValue) {
  for (Case c : cases()) {
    if (c.kind != AttributeKind::kUv) continue;
    const CodedAttribute good = code(make(c), bounds());
    for (const float huge : {1e6F, -1e12F, 3e38F}) {
      c.values[100 * c.components] = huge;
      const CodedAttribute coded = code(make(c), bounds());
      EXPECT_EQ(coding_byte(coded), static_cast<int>(c.coding) | kExceptionsFlag) << huge;
      EXPECT_LT(coded.payload.size(), good.payload.size() + 8 * c.components + 60);
      expect_bits(coded, c.values, c.components, 100);
    }
  }
}

TEST(Exceptions, ATTR12TheFirstAndTheLastVerticesMayBeExceptions) {
  for (Case c : cases()) {
    SCOPED_TRACE(static_cast<int>(c.kind));
    for (const std::uint32_t v : {0U, 1U, 2U, kVertices - 2, kVertices - 1})
      c.values[v * c.components] = v == 1 ? kInfinity : kNan;
    const CodedAttribute coded = code(make(c), bounds());
    EXPECT_EQ(coding_byte(coded), static_cast<int>(c.coding) | kExceptionsFlag);
    for (const std::uint32_t v : {0U, 1U, 2U, kVertices - 2, kVertices - 1})
      expect_bits(coded, c.values, c.components, v);
  }
}

TEST(Exceptions, ATTR12EqualValuesThatAreManyCostLittle) {
  Case c{AttributeKind::kGeneric, 1, AttributeCoding::kLattice, Sheet().heights};
  const std::size_t good = code(make(c), bounds()).payload.size();
  for (std::size_t v = 0; v < kVertices; ++v)
    if (v % 100 < 30) c.values[v] = kNan;
  EXPECT_LT(code(make(c), bounds()).payload.size(), good + 2 * (kVertices * 3 / 10));
}

TEST(Exceptions, ATTR12MostlyBadValuesAreExact) {
  Case c{AttributeKind::kNormal, 3, AttributeCoding::kSurfaceNormals, Sheet().normals};
  test::RandomBits random(4);
  for (std::size_t v = 0; v < kVertices; v += 2) {
    c.values[3 * v] = kNan;
    c.values[3 * v + 1] = static_cast<float>(random() % 1000);
  }
  const Attribute a = make(c);
  const Sheet sheet;
  const AttributeQuality quality;
  const auto coded =
      write_attribute(test::view(a), identity(kVertices), {.quality = quality}, sheet.surface(), {});
  ASSERT_TRUE(coded);
  EXPECT_EQ(coded->decoded.values, a.values);
  EXPECT_EQ(coded->descriptor.error, 0);
}

TEST(Exceptions, ATTR12TangentsWithoutDirectionOrSideAndForeignWeightsAndColors) {
  struct Bad {
    std::size_t of;
    std::vector<float> row;
  };
  const auto all = cases();
  for (const Bad& bad : {Bad{1, {0, 0, 0, 1}}, Bad{1, {1, 0, 0, 0}}, Bad{3, {0.5F, 7, 0.25F}},
                         Bad{4, {0, 0, 0, 0}}, Bad{4, {2, -1, 0, 0}}}) {
    Case c = all[bad.of];
    for (const std::size_t v : {40U, 41U, 700U})
      std::copy(bad.row.begin(), bad.row.end(),
                c.values.begin() + static_cast<std::ptrdiff_t>(v * c.components));
    const CodedAttribute coded = code(make(c), bounds());
    EXPECT_EQ(coding_byte(coded), static_cast<int>(c.coding) | kExceptionsFlag);
    for (const std::size_t v : {40U, 41U, 700U}) expect_bits(coded, c.values, c.components, v);
  }
}

TEST(Exceptions, ATTR12OthersArePredictedFromThemWithoutHarm) {
  Case normals{AttributeKind::kNormal, 3, AttributeCoding::kSurfaceNormals, Sheet().normals};
  for (std::size_t i = 300; i < 306; ++i) normals.values[i] = kNan;
  const std::vector<Attribute> others{code(make(normals), bounds()).decoded};
  const Case tangents{AttributeKind::kTangent, 4, AttributeCoding::kSurfaceTangents, Sheet().tangents};
  const CodedAttribute coded = code(make(tangents), bounds(), others);
  EXPECT_EQ(coding_byte(coded), static_cast<int>(AttributeCoding::kSurfaceTangents));
  EXPECT_LE(coded.descriptor.error, short_float_above(0.5));
}

TEST(Exceptions, ATTR12ExactValuesThatAreNotFiniteLeaveTheOthersPredicted) {
  Case c{AttributeKind::kNormal, 3, AttributeCoding::kLattice, Sheet().normals};
  c.values[99] = kNan;
  const CodedAttribute coded = code(make(c), test::kExactly);
  EXPECT_EQ(coding_byte(coded), static_cast<int>(AttributeCoding::kLattice) | kExceptionsFlag);
  EXPECT_EQ(coded.decoded.values, make(c).values);
}

TEST(Exceptions, DirectionsMayHaveAnyLength) {
  for (const float size : {1e-30F, 0.3F, 1.0F, 7.0F, 1e30F}) {
    for (std::size_t k = 0; k < 2; ++k) {
      Case c = cases()[k];
      for (std::size_t i = 0; i < c.values.size(); ++i)
        if (i % c.components < 3) c.values[i] *= size;
      const CodedAttribute coded = code(make(c), bounds());
      EXPECT_EQ(coding_byte(coded), static_cast<int>(c.coding)) << size;
      EXPECT_GT(coded.descriptor.error, 0);
      EXPECT_LE(coded.descriptor.error, short_float_above(0.5));
      // As many bytes as unit vectors take, up to rounding.
      EXPECT_LT(coded.payload.size(), code(make(cases()[k]), bounds()).payload.size() * 101 / 100 + 2);
    }
  }
}

TEST(Exceptions, LengthsThatAreDroppedAreCounted) {
  const Sheet sheet;
  Case normals = cases()[0];
  normals.values[0] = kNan;
  for (std::size_t i = 3; i < 9; ++i) normals.values[i] = 0;
  Mesh mesh;
  mesh.positions = sheet.positions;
  mesh.triangles = sheet.triangles;
  mesh.attributes = {make(normals)};
  EXPECT_EQ(encode(mesh)->report.dropped_lengths, kVertices - 3);
  EXPECT_EQ(encode(mesh, {.lossless = true})->report.dropped_lengths, 0U);
  mesh.attributes = {make(cases()[1])};
  EXPECT_EQ(encode(mesh)->report.dropped_lengths, kVertices);
  EXPECT_EQ(encode(mesh, {.attributes = {.tangent_error = 0}})->report.dropped_lengths, 0U);
  mesh.attributes = {make(cases()[2])};
  EXPECT_EQ(encode(mesh)->report.dropped_lengths, 0U);
}

/// A byte for each of `count` vertices, all 5, behind exceptions that `write` tells of.
template <class Write>
const char* broken_rule(std::uint32_t count, Write write) {
  ByteWriter out;
  out.write(static_cast<std::uint8_t>(static_cast<int>(AttributeCoding::kLattice) | kExceptionsFlag));
  write(out);
  for (const int byte : {0, 5}) out.write(static_cast<std::uint8_t>(byte));
  return test::broken_rule(out.take(), {.type = ComponentType::kU8, .components = 1}, count);
}

TEST(Exceptions, ATTR12BrokenRunsAreRefused) {
  const auto rule = [](std::vector<int> bytes) {
    return std::string(broken_rule(4, [&](ByteWriter& out) {
      for (const int byte : bytes) out.write(static_cast<std::uint8_t>(byte));
    }));
  };
  EXPECT_EQ(rule({1, 9, 1, 3, 0}), "none");
  EXPECT_EQ(rule({2, 9, 8, 2, 0, 1, 0, 0, 1, 1}), "none");
  EXPECT_EQ(rule({0, 1, 0, 0}), "ATTR-12");           // no value
  EXPECT_EQ(rule({1, 9, 0}), "ATTR-12");              // no run
  EXPECT_EQ(rule({1, 9, 2, 0, 3, 0, 0}), "ATTR-12");  // behind the last vertex
  EXPECT_EQ(rule({1, 9, 1, 4, 0}), "CON-2");
  EXPECT_EQ(rule({1, 9, 1, 2, 2}), "CON-2");
  EXPECT_EQ(rule({2, 9, 8, 1, 0, 0, 2}), "CON-2");
  EXPECT_EQ(rule({5}), "CON-2");
}

}  // namespace
}  // namespace deltamesh::exceptions_test
