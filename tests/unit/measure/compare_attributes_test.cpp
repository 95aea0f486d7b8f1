// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "deltamesh/compare.h"
#include "support/attribute_of.h"
#include "support/meshes.h"

namespace deltamesh {
namespace {

using test::attribute_of;

/// Squares of side 1 in a row, cut in two along seams: each square has its own four vertices, whose texture
/// coordinates tell them apart from their neighbours' copies.
Mesh strip(std::uint32_t squares) {
  Mesh mesh;
  std::vector<float> uv;
  std::vector<float> normals;
  for (std::uint32_t s = 0; s < squares; ++s) {
    const auto x = static_cast<float>(s);
    mesh.positions.insert(mesh.positions.end(), {x, 0, 0, x + 1, 0, 0, x + 1, 1, 0, x, 1, 0});
    const auto u = static_cast<float>(s * 7 % 5);
    uv.insert(uv.end(), {u, 0, u + 1, 0, u + 1, 1, u, 1});
    for (int i = 0; i < 4; ++i) normals.insert(normals.end(), {0, 0, 1});
    const std::uint32_t v = 4 * s;
    mesh.triangles.insert(mesh.triangles.end(), {v, v + 1, v + 2, v, v + 2, v + 3});
  }
  mesh.attributes.push_back(attribute_of(AttributeKind::kNormal, ComponentType::kF32, 3, "NORMAL", normals));
  mesh.attributes.push_back(attribute_of(AttributeKind::kUv, ComponentType::kF32, 2, "TEXCOORD_0", uv));
  return mesh;
}

float& value(Mesh& mesh, std::size_t attribute, std::size_t index) {
  return reinterpret_cast<float*>(mesh.attributes[attribute].values.data())[index];
}

TEST(CompareAttributes, TellsCopiesApartByTheirFaces) {
  const Mesh a = strip(40);
  Mesh b = test::shuffled(a, 11).mesh;
  std::mt19937 random(3);
  std::uniform_real_distribution<float> noise(-0.1F, 0.1F);
  for (std::size_t i = 2; i < b.positions.size(); i += 3) b.positions[i] += noise(random);
  const auto result = compare(a, b);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->corresponding);
  EXPECT_TRUE(result->reordered);
  ASSERT_EQ(result->attributes.size(), 2U);
  EXPECT_EQ(result->attributes[0].measured, 160U);
  EXPECT_EQ(result->attributes[0].max_error, 0);
  EXPECT_EQ(result->attributes[1].name, "TEXCOORD_0");
  EXPECT_EQ(result->attributes[1].match, AttributeMatch::kCompared);
  EXPECT_EQ(result->attributes[1].max_error, 0);
}

TEST(CompareAttributes, TellsFacesAtOnePlaceApartByTheirValues) {
  Mesh a = strip(1);
  const Mesh other = strip(1);
  a.positions.insert(a.positions.end(), other.positions.begin(), other.positions.end());
  for (const std::uint32_t v : other.triangles) a.triangles.push_back(v + 4);
  for (std::size_t i = 0; i < 2; ++i) {
    std::vector<std::byte>& values = a.attributes[i].values;
    values.insert(values.end(), other.attributes[i].values.begin(), other.attributes[i].values.end());
  }
  for (std::size_t i = 8; i < 16; ++i) value(a, 1, i) += 10;
  const auto result = compare(a, test::shuffled(a, 11).mesh);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->corresponding);
  EXPECT_EQ(result->attributes[1].max_error, 0);
}

TEST(CompareAttributes, MeasuresInTheUnitOfTheKind) {
  Mesh a = strip(2);
  const std::vector<std::uint8_t> colors(8 * 3, 100);
  a.attributes.push_back(attribute_of(AttributeKind::kColor, ComponentType::kU8, 3, "red", colors, true));
  const std::vector<std::uint16_t> weights(8 * 4, 65535 / 4);
  a.attributes.push_back(
      attribute_of(AttributeKind::kWeights, ComponentType::kU16, 4, "WEIGHTS_0", weights, true));
  const std::vector<float> intensity(8, 2);
  a.attributes.push_back(
      attribute_of(AttributeKind::kGeneric, ComponentType::kF32, 1, "intensity", intensity));
  const std::vector<std::int8_t> influences(8, 100);
  a.attributes.push_back(
      attribute_of(AttributeKind::kWeights, ComponentType::kI8, 1, "influence", influences));
  Mesh b = a;
  value(b, 0, 0) = 1;  // 45 degrees
  value(b, 1, 2) += 0.3F;
  value(b, 1, 3) -= 0.4F;
  b.attributes[2].values[4] = std::byte{110};
  std::vector<std::uint16_t> moved = weights;
  moved[5] = 65535 / 2;
  std::memcpy(b.attributes[3].values.data(), moved.data(), 2 * moved.size());
  value(b, 4, 7) = -1;
  b.attributes[5].values[3] = std::byte{0};
  const auto result = compare(a, b);
  ASSERT_TRUE(result);
  const auto& of = result->attributes;
  EXPECT_NEAR(of[0].max_error, 45, 1e-9);
  EXPECT_NEAR(of[0].mean, 45.0 / 8, 1e-9);
  EXPECT_NEAR(of[0].rms, 45.0 / std::sqrt(8.0), 1e-9);
  EXPECT_NEAR(of[1].max_error, 0.5, 1e-6);
  EXPECT_DOUBLE_EQ(of[2].max_error, 10);
  EXPECT_NEAR(of[2].color_rms, 10 / std::sqrt(24.0), 1e-9);
  EXPECT_NEAR(of[2].color_difference, 1.0620, 1e-3);
  EXPECT_EQ(of[3].color_rms, 0);
  EXPECT_NEAR(of[3].max_error, 0.25, 1e-4);
  EXPECT_DOUBLE_EQ(of[4].max_error, 3);
  EXPECT_DOUBLE_EQ(of[5].max_error, 100.0 / 127);
}

TEST(CompareAttributes, ComparesTangentsWithTheirSign) {
  Mesh a = strip(1);
  std::vector<float> tangents;
  for (int i = 0; i < 4; ++i) tangents.insert(tangents.end(), {1, 0, 0, 1});
  a.attributes.push_back(attribute_of(AttributeKind::kTangent, ComponentType::kF32, 4, "TANGENT", tangents));
  Mesh b = a;
  value(b, 2, 1) = 1;
  EXPECT_NEAR(compare(a, b)->attributes[2].max_error, 45, 1e-9);
  value(b, 2, 7) = -1;
  EXPECT_EQ(compare(a, b)->attributes[2].max_error, 180);
}

TEST(CompareAttributes, FindsPartnersByNameThenByKind) {
  Mesh a = strip(1);
  Mesh b = a;
  const std::vector<float> four(4, 0.0F);
  a.attributes.push_back(attribute_of(AttributeKind::kGeneric, ComponentType::kF32, 1, "confidence", four));
  b.attributes.push_back(attribute_of(AttributeKind::kGeneric, ComponentType::kF32, 1, "intensity", four));
  b.attributes[0].name = "nx";
  const std::vector<std::uint8_t> rgb(12);
  const std::vector<std::uint8_t> rgba(16);
  a.attributes.push_back(attribute_of(AttributeKind::kColor, ComponentType::kU8, 3, "red", rgb, true));
  b.attributes.push_back(attribute_of(AttributeKind::kColor, ComponentType::kU8, 4, "red", rgba, true));
  const auto result = compare(a, b);
  ASSERT_TRUE(result);
  std::vector<std::pair<std::string, AttributeMatch>> found;
  for (const AttributeComparison& attribute : result->attributes)
    found.emplace_back(attribute.name, attribute.match);
  const std::vector<std::pair<std::string, AttributeMatch>> expected{
      {"NORMAL", AttributeMatch::kCompared},
      {"TEXCOORD_0", AttributeMatch::kCompared},
      {"confidence", AttributeMatch::kMissingInB},
      {"red", AttributeMatch::kOtherType},
      {"intensity", AttributeMatch::kOnlyInB}};
  EXPECT_EQ(found, expected);
}

TEST(CompareAttributes, MeasuresTheFacesThatBothHave) {
  const Mesh a = strip(20);
  Mesh b = test::shuffled(a, 11).mesh;
  b.triangles.resize(b.triangles.size() - 9);
  b.triangles.insert(b.triangles.end(), {0, 40, 79});
  value(b, 1, 2 * std::size_t{b.triangles[0]}) += 0.5F;
  const auto result = compare(a, b);
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->corresponding);
  EXPECT_EQ(result->matched_faces, 37U);
  EXPECT_EQ(result->unmatched_faces_a, 3U);
  EXPECT_EQ(result->unmatched_faces_b, 1U);
  EXPECT_NEAR(result->attributes[1].max_error, 0.5, 1e-6);
}

TEST(CompareAttributes, TakesWhatIsNotANumber) {
  Mesh a = strip(1);
  value(a, 1, 0) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(compare(a, a)->attributes[1].max_error, 0);  // the same bits
  EXPECT_EQ(compare(a, strip(1))->attributes[1].max_error, std::numeric_limits<double>::infinity());
}

TEST(CompareAttributes, RejectsMissingValues) {
  const Mesh a = strip(1);
  Mesh b = a;
  b.attributes[1].values.pop_back();
  EXPECT_EQ(compare(a, b).error().code, ErrorCode::kInvalidMesh);
  EXPECT_EQ(compare(a, b).error().where, 1U);
  EXPECT_EQ(compare(b, a).error().code, ErrorCode::kInvalidMesh);
}

}  // namespace
}  // namespace deltamesh
