// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// PLY: what its writers disagree on, and hostile headers.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "io_support.h"

namespace deltamesh {
namespace {

using test::expect_error;
using test::expect_robust;
using test::find;
using test::left_out;
using test::numbers;
using test::read_text;

constexpr FileFormat kPly = FileFormat::kPly;

std::string with_vertices(const std::string& properties, const std::string& body, int count = 3) {
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(count) + '\n' + properties +
         "element face 1\nproperty list uchar int vertex_indices\nend_header\n" + body;
}
const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";

TEST(PlyReader, TriangulatesPolygonsAsFans) {
  const auto imported =
      read_text("ply\nformat ascii 1.0\nelement vertex 5\n" + kXyz +
                    "element face 4\nproperty list uchar int vertex_index\nend_header\n"
                    "0 0 0\n1 0 0\n2 1 0\n1 2 0\n0 1 0\n5 0 1 2 3 4\n3 0 1 2\n2 0 1\n4 4 3 2 1\n",
                kPly);
  ASSERT_TRUE(imported) << describe(imported.error());
  EXPECT_EQ(imported->mesh.triangles,
            (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 1, 2, 4, 3, 2, 4, 2, 1}));
  EXPECT_EQ(imported->report.polygons, 2U);
  EXPECT_EQ(left_out(imported->report, LeftOutKind::kFaces), 1U);
}

TEST(PlyReader, SkipsWhatItDoesNotKnow) {
  const auto imported = read_text(
      "ply\nformat ascii 1.0\ncomment made by hand\nelement camera 2\nproperty list uchar float matrix\n"
      "element vertex 3\nproperty list uchar int neighbours\n" +
          kXyz +
          "element empty 4000000000\nelement face 1\nproperty list uchar float weights\nproperty uchar "
          "flags\n"
          "property list short uint vertex_indices\nelement edge 2\nproperty int a\nend_header\n"
          "2 0.5 1\n0\n0 0 0 0\n1 7 1 0 0\n2 1 2 0 1 0\n2 9 9 1 3 0 1 2\n5\n6\n",
      kPly);
  ASSERT_TRUE(imported) << describe(imported.error());
  EXPECT_EQ(imported->mesh.positions, (std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}));
  EXPECT_EQ(imported->mesh.triangles, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_TRUE(imported->mesh.attributes.empty());
  EXPECT_EQ(left_out(imported->report, LeftOutKind::kPrimitives), 2U);
}

TEST(PlyReader, CountsAttributesWhoseNamesAStreamCannotHold) {
  const std::string names =
      "property float caf\xe9\nproperty int " + std::string(256, 'n') + "\nproperty uchar ok\n";
  const auto imported =
      read_text(with_vertices(kXyz + names, "0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 2 3\n3 0 1 2\n"), kPly);
  ASSERT_TRUE(imported) << describe(imported.error());
  ASSERT_EQ(imported->mesh.attributes.size(), 1U);
  EXPECT_EQ(imported->mesh.attributes[0].name, "ok");
  EXPECT_EQ(imported->report.left_out.size(), 2U);
  EXPECT_EQ(left_out(imported->report, LeftOutKind::kVertexValues, "caf\xe9"), 3U);
}

TEST(PlyReader, KnowsTheNamesOfColorsAndTextureCoordinates) {
  for (const std::string names : {"red green blue", "r g b", "diffuse_red diffuse_green diffuse_blue"}) {
    std::string properties = kXyz;
    for (std::size_t begin = 0; begin < names.size();) {
      const std::size_t end = std::min(names.find(' ', begin), names.size());
      properties += "property ushort " + names.substr(begin, end - begin) + '\n';
      begin = end + 1;
    }
    const auto imported =
        read_text(with_vertices(properties, "0 0 0 1 2 3\n1 0 0 4 5 6\n0 1 0 65535 0 0\n3 0 1 2\n"), kPly);
    ASSERT_TRUE(imported) << describe(imported.error());
    const Attribute* const color = find(imported->mesh, AttributeKind::kColor);
    ASSERT_NE(color, nullptr);
    EXPECT_TRUE(color->normalized);
    EXPECT_EQ(numbers<std::uint16_t>(*color), (std::vector<std::uint16_t>{1, 2, 3, 4, 5, 6, 65535, 0, 0}));
  }
  for (const std::string name : {"s t", "u v", "texture_u texture_v", "texture_s texture_t"}) {
    const std::size_t blank = name.find(' ');
    const auto imported = read_text(with_vertices(kXyz + "property double " + name.substr(0, blank) +
                                                      "\nproperty float " + name.substr(blank + 1) + '\n',
                                                  "0 0 0 1 2\n1 0 0 3 4\n0 1 0 5 6\n3 0 1 2\n"),
                                    kPly);
    ASSERT_TRUE(imported) << describe(imported.error());
    const Attribute* const uv = find(imported->mesh, AttributeKind::kUv);
    ASSERT_NE(uv, nullptr);
    EXPECT_EQ(numbers<float>(*uv), (std::vector<float>{1, 2, 3, 4, 5, 6}));
  }
}

TEST(PlyReader, ColorsOfOddTypesStayGeneric) {
  const auto imported =
      read_text(with_vertices(kXyz + "property int red\nproperty int green\nproperty int blue\n",
                              "0 0 0 1 2 3\n1 0 0 4 5 6\n0 1 0 7 8 9\n3 0 1 2\n"),
                kPly);
  ASSERT_TRUE(imported) << describe(imported.error());
  ASSERT_EQ(imported->mesh.attributes.size(), 3U);
  EXPECT_EQ(imported->mesh.attributes[1].name, "green");
  EXPECT_EQ(imported->mesh.attributes[1].kind, AttributeKind::kGeneric);
}

TEST(PlyReader, RepeatedPropertiesCountOnce) {
  const auto imported =
      read_text(with_vertices(kXyz + "property float x\nproperty uchar q\nproperty uchar q\n",
                              "0 0 0 9 1 2\n1 0 0 9 3 4\n0 1 0 9 5 6\n3 0 1 2\n"),
                kPly);
  ASSERT_TRUE(imported) << describe(imported.error());
  EXPECT_EQ(imported->mesh.positions[3], 1.0F);
  ASSERT_EQ(imported->mesh.attributes.size(), 1U);
  EXPECT_EQ(numbers<std::uint8_t>(imported->mesh.attributes[0]), (std::vector<std::uint8_t>{1, 3, 5}));
}

TEST(PlyReader, LineEndsOfAllKinds) {
  const std::string text = with_vertices(kXyz, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  for (const std::string_view end : {"\r\n", "\r"}) {
    std::string changed;
    for (const char c : text) c == '\n' ? changed += end : changed += c;
    const auto imported = read_text(changed, kPly);
    ASSERT_TRUE(imported) << describe(imported.error());
    EXPECT_EQ(imported->mesh.triangle_count(), 1U);
  }
  // The data of a binary file may begin with a line feed: the header's own ends decide.
  std::string binary =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar x\nproperty uchar y\n"
      "property uchar z\nend_header\n\n\r\n";
  const auto imported = read_text(binary, kPly);
  ASSERT_TRUE(imported) << describe(imported.error());
  EXPECT_EQ(imported->mesh.vertex_count(), 1U);
}

TEST(PlyReader, NonFiniteCoordinatesAreKept) {
  const auto imported = read_text(with_vertices(kXyz, "nan 0 0\n1 -inf 0\n0 1 +0.5\n3 0 1 2\n"), kPly);
  ASSERT_TRUE(imported) << describe(imported.error());
  EXPECT_TRUE(std::isnan(imported->mesh.positions[0]));
  EXPECT_EQ(imported->mesh.positions[4], -INFINITY);
  EXPECT_EQ(imported->mesh.positions[8], 0.5F);
}

TEST(PlyReader, DoubleCoordinatesKeepTheirPlace) {
  const auto imported = read_text(with_vertices("property double x\nproperty double y\nproperty double z\n",
                                                "465000.123 5120000.001 0\n465010.125 5120000.002 1\n"
                                                "465000.124 5120009.5 2\n3 0 1 2\n"),
                                  kPly);
  ASSERT_TRUE(imported) << describe(imported.error());
  const Mesh& mesh = imported->mesh;
  EXPECT_EQ(mesh.origin[0], std::round(mesh.origin[0]));
  EXPECT_EQ(mesh.origin[2], 0);
  EXPECT_NEAR(mesh.origin[0] + static_cast<double>(mesh.positions[0]), 465000.123, 1e-6);
  EXPECT_NEAR(mesh.origin[1] + static_cast<double>(mesh.positions[4]), 5120000.002, 1e-6);
}

TEST(PlyReader, ErrorsNameTheirLine) {
  expect_error("", kPly, WhereKind::kLine, 1);
  expect_error("obj\n", kPly, WhereKind::kLine, 1);
  expect_error("ply\nformat ascii 2.0\n", kPly, WhereKind::kLine, 2);
  expect_error("ply\nformat ascii 1.0\nproperty float x\n", kPly, WhereKind::kLine, 3);
  expect_error("ply\nformat ascii 1.0\nelement vertex -1\n", kPly, WhereKind::kLine, 3);
  expect_error("ply\nformat ascii 1.0\nelement vertex 3\nproperty list float int x\n", kPly, WhereKind::kLine,
               4);
  expect_error("ply\nend_header\n", kPly, WhereKind::kLine, 2);
  expect_error(with_vertices(kXyz, "0 0 0\n1 0 0\n0 one 0\n3 0 1 2\n"), kPly, WhereKind::kLine, 12);
  expect_error(with_vertices(kXyz, "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"), kPly, WhereKind::kLine, 13);
  expect_error(with_vertices(kXyz, "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"), kPly, WhereKind::kLine, 13);
  expect_error(with_vertices(kXyz, "0 0 0\n1 0 0\n0 1 0\n300 0 1 2\n"), kPly, WhereKind::kLine, 13);
  expect_error(with_vertices(kXyz + "property list char int odd\n", "0 0 0 0\n1 0 0 -1\n0 1 0 0\n3 0 1 2\n"),
               kPly, WhereKind::kLine, 12);
  expect_error(with_vertices(kXyz, "0 0 0\n1 0 0\n0 1 0\n4 0 1 2\n"), kPly);
  expect_error(with_vertices("property float x\nproperty float y\n", "0 0\n1 0\n0 1\n3 0 1 2\n"), kPly);
  expect_error("ply\nformat ascii 1.0\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n",
               kPly);
  expect_error(
      "ply\nformat ascii 1.0\nelement vertex 3\n" + kXyz +
          "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0 1 0 0 0 1 0 3 0 1 2",
      kPly);
}

TEST(PlyReader, CountsAreCheckedBeforeAllocation) {
  for (const char* encoding : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    for (const char* count : {"4000000000", "4294967295", "4294967296", "18446744073709551615"}) {
      expect_error(std::string("ply\nformat ") + encoding + " 1.0\nelement vertex " + count + '\n' + kXyz +
                       "end_header\n",
                   kPly);
      expect_error(std::string("ply\nformat ") + encoding + " 1.0\nelement vertex 0\n" + kXyz +
                       "element face " + count + "\nproperty list uchar int vertex_indices\nend_header\n",
                   kPly);
    }
  }
}

TEST(PlyReader, ManyPropertiesTakeLinearTime) {
  std::string properties = kXyz;
  for (int i = 0; i < 50000; ++i) properties += "property char p" + std::to_string(i) + '\n';
  const auto imported = read_text(with_vertices(properties, "", 0) + "", kPly);
  EXPECT_FALSE(imported);  // its one face is missing
}

TEST(PlyReader, BinarySurvivesTruncation) {
  std::string text =
      "ply\nformat binary_big_endian 1.0\nelement vertex 2\nproperty list uchar char l\n"
      "property short x\nproperty short y\nproperty double z\nelement face 1\n"
      "property list char char vertex_indices\nend_header\n";
  text += std::string("\2\1\1\0\1\0\2\0\0\0\0\0\0\0\0\0\0\5\0\2\0\0\0\0\0\0\0\0\3\0\1\0", 32);
  const auto imported = read_text(text, kPly);
  ASSERT_TRUE(imported) << describe(imported.error());
  EXPECT_EQ(imported->mesh.positions, (std::vector<float>{1, 2, 0, 5, 2, 0}));
  EXPECT_EQ(imported->mesh.triangles, (std::vector<std::uint32_t>{0, 1, 0}));
  expect_robust(test::bytes_of(text), kPly);
}

}  // namespace
}  // namespace deltamesh
