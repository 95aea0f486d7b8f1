// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What is written reads back: every format, with what it can carry.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>

#include "deltamesh/io.h"
#include "io_support.h"

namespace deltamesh {
namespace {

using test::attribute;
using test::dressed_mesh;
using test::expect_robust;
using test::expect_valid;
using test::find;
using test::numbers;
using test::small_mesh;

constexpr FileFormat kFormats[] = {FileFormat::kPly, FileFormat::kObj,  FileFormat::kStl,
                                   FileFormat::kOff, FileFormat::kGltf, FileFormat::kGlb};

Mesh round_trip(const Mesh& mesh, FileFormat format) {
  const auto bytes = write_mesh(mesh, format);
  EXPECT_TRUE(bytes) << describe(bytes.error());
  if (!bytes) return {};
  auto imported = test::read_exact(*bytes, format);
  EXPECT_TRUE(imported) << describe(imported.error());
  if (!imported) return {};
  expect_valid(imported->mesh);
  return std::move(imported->mesh);
}

class EveryFormat : public ::testing::TestWithParam<FileFormat> {};
INSTANTIATE_TEST_SUITE_P(Io, EveryFormat, ::testing::ValuesIn(kFormats));

TEST_P(EveryFormat, PositionsAndTrianglesAreExact) {
  const Mesh mesh = small_mesh();
  const Mesh back = round_trip(mesh, GetParam());
  EXPECT_EQ(back.origin, mesh.origin);
  EXPECT_EQ(back.positions, mesh.positions);
  EXPECT_EQ(back.triangles, mesh.triangles);
  EXPECT_TRUE(back.attributes.empty());
}

TEST_P(EveryFormat, WritesTheSameBytesTwice) {
  const Mesh mesh = dressed_mesh();
  EXPECT_EQ(*write_mesh(mesh, GetParam()), *write_mesh(mesh, GetParam()));
}

TEST_P(EveryFormat, EmptyMesh) {
  const Mesh back = round_trip(Mesh{}, GetParam());
  EXPECT_EQ(back.vertex_count(), 0U);
  EXPECT_EQ(back.triangle_count(), 0U);
}

TEST_P(EveryFormat, VerticesWithoutTriangles) {
  Mesh mesh = small_mesh();
  mesh.triangles.clear();
  EXPECT_EQ(round_trip(mesh, GetParam()).triangle_count(), 0U);
}

TEST_P(EveryFormat, DegenerateAndDuplicateFacesSurvive) {
  Mesh mesh = small_mesh();
  mesh.triangles.insert(mesh.triangles.end(), {0, 0, 1, 2, 2, 2, 0, 1, 2, 2, 1, 0});
  EXPECT_EQ(round_trip(mesh, GetParam()).triangles, mesh.triangles);
}

TEST_P(EveryFormat, FarFromTheOriginKeepsMillimetres) {
  if (GetParam() == FileFormat::kStl) GTEST_SKIP() << "STL is float32 only";
  Mesh mesh = small_mesh();
  mesh.positions = {0.001F, 0, 0, 1.25F, 0.002F, 1, 0, 1e-3F, 3, -0.3F, 7, 8.125F};
  mesh.origin = {465000, 5120000, -3000};
  const Mesh back = round_trip(mesh, GetParam());
  ASSERT_EQ(back.positions.size(), mesh.positions.size());
  for (std::size_t i = 0; i < back.positions.size(); ++i) {
    const double was = mesh.origin[i % 3] + static_cast<double>(mesh.positions[i]);
    const double is = back.origin[i % 3] + static_cast<double>(back.positions[i]);
    EXPECT_NEAR(is, was, 1e-6);
  }
}

TEST_P(EveryFormat, SurvivesTruncationAndFlippedBytes) {
  expect_robust(*write_mesh(dressed_mesh(), GetParam()), GetParam());
}

TEST_P(EveryFormat, RefusesBrokenMeshes) {
  Mesh mesh = small_mesh();
  mesh.triangles[4] = 4;
  const auto index = write_mesh(mesh, GetParam());
  ASSERT_FALSE(index);
  EXPECT_EQ(index.error().code, ErrorCode::kInvalidMesh);
  EXPECT_EQ(index.error().where_kind, WhereKind::kTriangle);
  EXPECT_EQ(index.error().where, 1U);
  mesh = dressed_mesh();
  mesh.attributes[1].values.pop_back();
  const auto values = write_mesh(mesh, GetParam());
  ASSERT_FALSE(values);
  EXPECT_EQ(values.error().where_kind, WhereKind::kAttribute);
  EXPECT_EQ(values.error().where, 1U);
}

TEST_P(EveryFormat, RefusesAttributesWithoutComponentsOrWithTooMany) {
  for (const AttributeKind kind :
       {AttributeKind::kGeneric, AttributeKind::kNormal, AttributeKind::kColor, AttributeKind::kUv,
        AttributeKind::kTangent, AttributeKind::kJoints, AttributeKind::kWeights})
    for (const ComponentType type : {ComponentType::kU8, ComponentType::kF64})
      for (const unsigned components : {0U, 17U, 255U}) {
        Mesh mesh = small_mesh();
        Attribute& odd = mesh.attributes.emplace_back(Attribute{.kind = kind, .type = type, .name = "x"});
        odd.components = static_cast<std::uint8_t>(components);
        odd.values.resize(mesh.vertex_count() * components * component_size(type));
        const auto written = write_mesh(mesh, GetParam());
        ASSERT_FALSE(written);
        EXPECT_EQ(written.error().code, ErrorCode::kInvalidMesh);
        EXPECT_EQ(written.error().where_kind, WhereKind::kAttribute);
        EXPECT_EQ(written.error().where, 0U);
      }
}

TEST_P(EveryFormat, NonFiniteCoordinatesAreKeptOrRefused) {
  Mesh mesh = small_mesh();
  mesh.positions[4] = std::numeric_limits<float>::quiet_NaN();
  mesh.positions[6] = -std::numeric_limits<float>::infinity();
  if (GetParam() == FileFormat::kGlb || GetParam() == FileFormat::kGltf) {
    const auto bytes = write_mesh(mesh, GetParam());
    ASSERT_FALSE(bytes);
    EXPECT_EQ(bytes.error().code, ErrorCode::kNotFinite);
    EXPECT_EQ(bytes.error().where, 1U);
    return;
  }
  const Mesh back = round_trip(mesh, GetParam());
  ASSERT_EQ(back.positions.size(), mesh.positions.size());
  EXPECT_TRUE(std::isnan(back.positions[4]));
  EXPECT_EQ(back.positions[6], mesh.positions[6]);
  EXPECT_EQ(back.positions[7], mesh.positions[7]);
}

TEST_P(EveryFormat, AttributesSurviveWhereTheFormatHasThem) {
  if (GetParam() == FileFormat::kStl) GTEST_SKIP() << "STL has no attributes";
  Mesh mesh = dressed_mesh();
  mesh.attributes[2].linear = GetParam() == FileFormat::kGltf || GetParam() == FileFormat::kGlb;
  const Mesh back = round_trip(mesh, GetParam());
  for (const AttributeKind kind : {AttributeKind::kNormal, AttributeKind::kUv}) {
    ASSERT_NE(find(back, kind), nullptr);
    EXPECT_EQ(numbers<float>(*find(back, kind)), numbers<float>(*find(mesh, kind)));
  }
  const Attribute* const color = find(back, AttributeKind::kColor);
  ASSERT_NE(color, nullptr);
  if (GetParam() == FileFormat::kObj) {
    EXPECT_EQ(color->components, 3);
    EXPECT_EQ(numbers<float>(*color)[4], static_cast<float>(128 / 255.0));
  } else {
    EXPECT_EQ(color->type, ComponentType::kU8);
    EXPECT_TRUE(color->normalized);
    EXPECT_EQ(color->values, find(mesh, AttributeKind::kColor)->values);
  }
}

TEST(IoPly, EveryComponentTypeSurvives) {
  Mesh mesh = small_mesh();
  mesh.attributes.push_back(
      attribute<std::int8_t>(AttributeKind::kGeneric, ComponentType::kI8, 1, "a", {-128, 127, 0, 1}));
  mesh.attributes.push_back(
      attribute<std::uint8_t>(AttributeKind::kGeneric, ComponentType::kU8, 1, "b", {255, 0, 1, 2}));
  mesh.attributes.push_back(
      attribute<std::int16_t>(AttributeKind::kGeneric, ComponentType::kI16, 1, "c", {-32768, 32767, 0, 1}));
  mesh.attributes.push_back(
      attribute<std::uint16_t>(AttributeKind::kGeneric, ComponentType::kU16, 1, "d", {65535, 0, 1, 2}));
  mesh.attributes.push_back(attribute<std::int32_t>(AttributeKind::kGeneric, ComponentType::kI32, 1, "e",
                                                    {-2147483647 - 1, 2147483647, 0, 1}));
  mesh.attributes.push_back(
      attribute<std::uint32_t>(AttributeKind::kGeneric, ComponentType::kU32, 1, "f", {4294967295U, 0, 1, 2}));
  mesh.attributes.push_back(
      attribute<float>(AttributeKind::kGeneric, ComponentType::kF32, 1, "g", {0.1F, -0.0F, 3e38F, 1e-45F}));
  mesh.attributes.push_back(
      attribute<double>(AttributeKind::kGeneric, ComponentType::kF64, 1, "h", {0.1, -0.0, 1e300, 5e-324}));
  const Mesh back = round_trip(mesh, FileFormat::kPly);
  ASSERT_EQ(back.attributes.size(), mesh.attributes.size());
  for (std::size_t a = 0; a < mesh.attributes.size(); ++a) {
    EXPECT_EQ(back.attributes[a].name, mesh.attributes[a].name);
    EXPECT_EQ(back.attributes[a].type, mesh.attributes[a].type);
    EXPECT_EQ(back.attributes[a].values, mesh.attributes[a].values);
  }
}

TEST(IoPly, NamesThatCollideOrHoldBlanksAreMadeUnique) {
  Mesh mesh = small_mesh();
  for (const char* name : {"x", "two words", "", "two words"})
    mesh.attributes.push_back(
        attribute<std::uint8_t>(AttributeKind::kGeneric, ComponentType::kU8, 1, name, {1, 2, 3, 4}));
  mesh.attributes.push_back(attribute<std::uint8_t>(AttributeKind::kGeneric, ComponentType::kU8, 2, "pair",
                                                    {1, 2, 3, 4, 5, 6, 7, 8}));
  const Mesh back = round_trip(mesh, FileFormat::kPly);
  EXPECT_EQ(back.positions, mesh.positions);
  std::vector<std::string> names;
  for (const Attribute& a : back.attributes) names.push_back(a.name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"x_", "two_words", "attribute", "two_words_", "pair_0", "pair_1"}));
}

TEST(IoPly, WideColorsKeepTheirType) {
  Mesh mesh = small_mesh();
  mesh.attributes.push_back(attribute<std::uint16_t>(AttributeKind::kColor, ComponentType::kU16, 3, "red",
                                                     {0, 65535, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
  const Mesh back = round_trip(mesh, FileFormat::kPly);
  ASSERT_NE(find(back, AttributeKind::kColor), nullptr);
  EXPECT_EQ(find(back, AttributeKind::kColor)->type, ComponentType::kU16);
  EXPECT_EQ(find(back, AttributeKind::kColor)->values, mesh.attributes[0].values);
}

TEST(IoGlb, CustomAttributesKeepTypeAndName) {
  Mesh mesh = small_mesh();
  mesh.attributes.push_back(
      attribute<std::uint8_t>(AttributeKind::kGeneric, ComponentType::kU8, 1, "confidence", {1, 2, 3, 4}));
  mesh.attributes.push_back(attribute<std::int16_t>(AttributeKind::kGeneric, ComponentType::kI16, 3, "_FLOW",
                                                    {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, -12}));
  mesh.attributes.push_back(
      attribute<std::uint32_t>(AttributeKind::kGeneric, ComponentType::kU32, 1, "too_wide", {1, 2, 3, 4}));
  const Mesh back = round_trip(mesh, FileFormat::kGlb);
  ASSERT_EQ(back.attributes.size(), 3U);
  EXPECT_EQ(back.attributes[0].name, "_FLOW");
  EXPECT_EQ(back.attributes[0].values, mesh.attributes[1].values);
  EXPECT_EQ(back.attributes[1].name, "_confidence");
  EXPECT_EQ(back.attributes[1].values, mesh.attributes[0].values);
}

TEST(IoGlb, ManyVerticesTakeWideIndices) {
  Mesh mesh;
  for (std::size_t i = 0; i < 66000; ++i)
    mesh.positions.insert(mesh.positions.end(), {static_cast<float>(i), static_cast<float>(i % 7), 0});
  mesh.triangles = {65534, 65535, 65999};
  EXPECT_EQ(round_trip(mesh, FileFormat::kGlb).triangles, mesh.triangles);
}

TEST(IoFiles, FormatBySuffix) {
  EXPECT_EQ(*format_of_path("a/b.PLY"), FileFormat::kPly);
  EXPECT_EQ(*format_of_path("x.GlTf"), FileFormat::kGltf);
  EXPECT_EQ(*format_of_path(".stl"), FileFormat::kStl);
  for (const char* path : {"", "ply", "a.plyx", "a.ply/b", "a.dmsh"}) {
    const auto format = format_of_path(path);
    ASSERT_FALSE(format) << path;
    EXPECT_EQ(format.error().code, ErrorCode::kUnknownFormat);
  }
}

TEST(IoFiles, WritesAndReadsFiles) {
  const auto path = (std::filesystem::path(::testing::TempDir()) / "deltamesh_io_test.glb").string();
  const Mesh mesh = dressed_mesh();
  ASSERT_TRUE(write_mesh_file(path, mesh));
  const auto imported = read_mesh_file(path);
  std::remove(path.c_str());
  ASSERT_TRUE(imported) << describe(imported.error());
  EXPECT_EQ(imported->mesh.triangles, mesh.triangles);
  const auto missing = read_mesh_file(path);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::kFileOpen);
}

}  // namespace
}  // namespace deltamesh
