// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Colours keep what they look like: PLY, OBJ and OFF hold what a screen shows, glTF linear light, streams say
// which.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <string>

#include "deltamesh/compare.h"
#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "io_support.h"

namespace deltamesh::colors_test {
namespace {

using test::attribute;
using test::find;
using test::left_out;
using test::numbers;

constexpr auto kColor = AttributeKind::kColor;

/// A strip with a vertex for each of the 256 values of a byte, as red, green, blue and alpha in other orders.
Mesh all_bytes() {
  Mesh mesh;
  std::vector<std::uint8_t> colors;
  for (std::uint32_t i = 0; i < 256; ++i) {
    mesh.positions.insert(mesh.positions.end(), {static_cast<float>(i / 2), static_cast<float>(i % 2), 0});
    if (i >= 2) mesh.triangles.insert(mesh.triangles.end(), {i - 2, i - 1, i});
    for (const std::uint32_t c : {i, 255 - i, i ^ 85U, i}) colors.push_back(static_cast<std::uint8_t>(c));
  }
  mesh.attributes.push_back(attribute<std::uint8_t>(kColor, ComponentType::kU8, 4, "red", colors));
  return mesh;
}

/// Through a stream that keeps the order, then a file of `format`.
Mesh passed_on(const Mesh& mesh, FileFormat format, WriteReport* report = nullptr) {
  const auto encoded = encode(mesh, {.keep_order = true});
  EXPECT_TRUE(encoded);
  const auto decoded = decode(encoded->bytes);
  EXPECT_TRUE(decoded);
  const auto file = write_mesh(*decoded, format, report);
  EXPECT_TRUE(file);
  const auto read = read_mesh(*file, format);
  EXPECT_TRUE(read) << describe(read.error());
  return read->mesh;
}

const Attribute& color_of(const Mesh& mesh) {
  const Attribute* const color = find(mesh, kColor);
  EXPECT_NE(color, nullptr);
  return *color;
}

TEST(Colors, All256ValuesSurvivePlyStreamGlbStreamPly) {
  const Mesh source = all_bytes();
  for (const FileFormat gltf : {FileFormat::kGlb, FileFormat::kGltf}) {
    WriteReport report;
    const Mesh light = passed_on(source, gltf, &report);
    EXPECT_TRUE(color_of(light).linear);
    EXPECT_EQ(color_of(light).type, ComponentType::kU16);
    for (const FileFormat text : {FileFormat::kPly, FileFormat::kOff}) {
      const Mesh back = passed_on(light, text, &report);
      EXPECT_FALSE(color_of(back).linear);
      EXPECT_EQ(numbers<std::uint8_t>(color_of(back)), numbers<std::uint8_t>(source.attributes[0]));
    }
    EXPECT_TRUE(report.left_out.empty());
  }
}

TEST(Colors, GltfHoldsLinearLight) {
  Mesh mesh = all_bytes();
  auto light = numbers<std::uint16_t>(color_of(passed_on(mesh, FileFormat::kGlb)));
  EXPECT_NEAR(light[4 * 188] / 65535.0, 0.5029, 1e-4);
  EXPECT_EQ(light[4 * 255], 65535);
  EXPECT_EQ(light[4 * 188 + 3], 188 * 257);  // alpha is no light
}

TEST(Colors, FloatsAnd16BitsComeBack) {
  Mesh mesh = test::small_mesh();
  mesh.attributes = {
      attribute<float>(kColor, ComponentType::kF32, 3, "rgb",
                       {0, 0.001F, 0.04F, 0.05F, 0.5F, 0.737F, 1, 0.99F, 0.25F, 0.1F, 0.2F, 0.3F})};
  const Mesh light = passed_on(mesh, FileFormat::kGlb);
  const Mesh back = passed_on(light, FileFormat::kPly);
  for (std::size_t i = 0; i < 12; ++i)
    EXPECT_NEAR(numbers<float>(color_of(back))[i], numbers<float>(mesh.attributes[0])[i], 1e-6);
  mesh.attributes = {
      attribute<std::uint16_t>(kColor, ComponentType::kU16, 3, "red",
                               {0, 1, 2, 3, 1000, 65535, 65534, 30000, 40000, 50000, 60000, 257})};
  const Mesh wide = passed_on(passed_on(mesh, FileFormat::kGlb), FileFormat::kPly);
  for (std::size_t i = 0; i < 12; ++i)
    EXPECT_NEAR(numbers<float>(color_of(wide))[i] * 65535, numbers<std::uint16_t>(mesh.attributes[0])[i],
                0.02);
}

TEST(Colors, WhatRoundsOnAScreenIsTold) {
  Mesh mesh = test::small_mesh();
  mesh.attributes = {attribute<std::uint8_t>(kColor, ComponentType::kU8, 3, "COLOR_0",
                                             {0, 255, 0, 0, 0, 0, 254, 253, 252, 128, 129, 130})};
  mesh.attributes[0].linear = true;
  WriteReport report;
  const Mesh shown = passed_on(mesh, FileFormat::kPly, &report);
  EXPECT_EQ(numbers<std::uint8_t>(color_of(shown))[9], 188);
  EXPECT_EQ(left_out(report, LeftOutKind::kPrecision, "COLOR_0"),
            2U);  // 252 to 254 become two values, as do 128 to 130
}

TEST(Colors, FloatsUpTo255AreBytesOrPartsOf255) {
  const std::string end = "0 1 2\n";
  const auto ply = [&](const std::string& type, const std::string& a, const std::string& b) {
    return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
           "z\nproperty " +
           type + " red\nproperty " + type + " green\nproperty " + type + " blue\nelement face 1\n" +
           "property list uchar int vertex_indices\nend_header\n0 0 0 " + a + "\n1 0 0 " + b + "\n0 1 0 " +
           a + "\n3 " + end;
  };
  for (const char* type : {"float", "double"}) {
    const auto whole = test::read_text(ply(type, "255 0 188", "1 2 3"), FileFormat::kPly);
    ASSERT_TRUE(whole);
    EXPECT_EQ(numbers<std::uint8_t>(color_of(whole->mesh)),
              (std::vector<std::uint8_t>{255, 0, 188, 1, 2, 3, 255, 0, 188}));
    EXPECT_EQ(left_out(whole->report, LeftOutKind::kGuesses), 3U);
    const auto parts = test::read_text(ply(type, "255 0 187.5", "1 2 3"), FileFormat::kPly);
    ASSERT_TRUE(parts);
    EXPECT_NEAR(numbers<float>(color_of(parts->mesh))[2], 187.5 / 255, 1e-6);
    for (const float c : numbers<float>(color_of(passed_on(parts->mesh, FileFormat::kGlb))))
      EXPECT_TRUE(c >= 0 && c <= 1);
    const auto bright = test::read_text(ply(type, "1 0 1.25", "1 1 1"), FileFormat::kPly);
    ASSERT_TRUE(bright);
    EXPECT_EQ(numbers<float>(color_of(bright->mesh))[2], 1.25F);
  }
  const auto obj =
      test::read_text("v 0 0 0 255 128 0\nv 1 0 0 0 0 7\nv 0 1 0 0 0 0\nf 1 2 3\n", FileFormat::kObj);
  ASSERT_TRUE(obj);
  EXPECT_EQ(color_of(obj->mesh).type, ComponentType::kU8);
  const auto off = test::read_text(
      "COFF\n3 1 0\n0 0 0 255.0 128.0 0.0 1.0\n1 0 0 0.0 0.0 7.0 1.0\n0 1 0 0.0 0.0 0.0 1.0\n3 0 1 2\n",
      FileFormat::kOff);
  ASSERT_TRUE(off);
  EXPECT_EQ(numbers<std::uint8_t>(color_of(off->mesh))[3], 255);  // an alpha of 1 is opaque
}

TEST(Colors, StreamsSayWhichAndComparisonsConvert) {
  const Mesh source = all_bytes();
  const Mesh light = passed_on(source, FileFormat::kGlb);
  const auto shown = encode(source);
  const auto linear = encode(light);
  ASSERT_TRUE(shown && linear);
  EXPECT_FALSE(inspect(shown->bytes)->attributes[0].linear);
  EXPECT_TRUE(inspect(linear->bytes)->attributes[0].linear);
  const auto compared = compare(source, light);
  ASSERT_TRUE(compared);
  ASSERT_EQ(compared->attributes.size(), 1U);
  EXPECT_EQ(compared->attributes[0].match, AttributeMatch::kCompared);
  EXPECT_LT(compared->attributes[0].max_error, 0.05);
  EXPECT_GT(compared->attributes[0].measured, 0U);
}

}  // namespace
}  // namespace deltamesh::colors_test
