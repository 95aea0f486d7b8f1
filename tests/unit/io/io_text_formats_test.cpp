// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// OBJ, STL and OFF: what their writers disagree on, and hostile files.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "io_support.h"

namespace deltamesh {
namespace {

using test::bytes_of;
using test::expect_error;
using test::expect_robust;
using test::find;
using test::left_out;
using test::numbers;
using test::read_exact;
using test::read_text;

TEST(ObjReader, SplitsVerticesAtSeamsAndKeepsTheirOrder) {
  const auto imported = read_text(
      "v 0 0 0\nv 1 0 0\nv 9 9 9\nv 1 1 0\nv 0 1 0\n"
      "vt 0 0\nvt 1 0\nvt 1 1\nvt 0.5 0.5\nvn 0 0 1\nvn 0 0 -1\n"
      "f 1/1/1 2/2/1 4/3/1\nf 1/4/1 4/3/1 5/1/2\n",
      FileFormat::kObj);
  ASSERT_TRUE(imported) << describe(imported.error());
  const Mesh& mesh = imported->mesh;
  ASSERT_EQ(mesh.vertex_count(),
            6U);  // five positions, the unused one included, and a second copy of the first
  EXPECT_EQ(mesh.triangles, (std::vector<std::uint32_t>{0, 1, 3, 5, 3, 4}));
  EXPECT_EQ(mesh.positions[6], 9.0F);
  EXPECT_EQ(mesh.positions[15], 0.0F);
  const auto uv = numbers<float>(*find(mesh, AttributeKind::kUv));
  EXPECT_EQ(uv[10], 0.5F);
  const auto normals = numbers<float>(*find(mesh, AttributeKind::kNormal));
  EXPECT_EQ(normals[14], -1.0F);
}

TEST(ObjReader, NegativeIndicesCountBack) {
  const auto imported =
      read_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -1 -2 -3\n", FileFormat::kObj);
  ASSERT_TRUE(imported) << describe(imported.error());
  EXPECT_EQ(imported->mesh.triangles, (std::vector<std::uint32_t>{0, 1, 2, 3, 2, 1}));
}

TEST(ObjReader, ForwardReferencesContinuationAndLineEnds) {
  const auto imported =
      read_text("f 1 2 3 \\\r\n 4\r\nv 0 0 0\rv 1 0 0\r\n\tv 1 1 0\nv 0 1 0", FileFormat::kObj);
  ASSERT_TRUE(imported) << describe(imported.error());
  EXPECT_EQ(imported->mesh.triangles, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(imported->report.polygons, 1U);
}

TEST(ObjReader, LargePolygonsBecomeFans) {
  std::string text;
  std::string face = "f";
  for (int i = 0; i < 300; ++i) {
    text += "v " + std::to_string(i) + " 0 0\n";
    face += ' ' + std::to_string(i + 1);
  }
  const auto imported = read_text(text + face + "\nf 1 2\nl 1 2\np 1\n", FileFormat::kObj);
  ASSERT_TRUE(imported) << describe(imported.error());
  EXPECT_EQ(imported->mesh.triangle_count(), 298U);
  EXPECT_EQ(left_out(imported->report, LeftOutKind::kFaces), 1U);
  EXPECT_EQ(left_out(imported->report, LeftOutKind::kPrimitives), 2U);
}

TEST(ObjReader, ColorsOnlyWhereEveryVertexHasThem) {
  const std::string face = "f 1 2 3\n";
  const auto all = read_text("v 0 0 0 1 0 0.5\nv 1 0 0 0 0 0\nv 0 1 0 0 0 1 1\n" + face, FileFormat::kObj);
  ASSERT_TRUE(all) << describe(all.error());
  ASSERT_NE(find(all->mesh, AttributeKind::kColor), nullptr);
  EXPECT_EQ(numbers<float>(*find(all->mesh, AttributeKind::kColor))[2], 0.5F);
  const auto some = read_text("v 0 0 0 1 0 0.5\nv 1 0 0\nv 0 1 0 0 0 1\n" + face, FileFormat::kObj);
  ASSERT_TRUE(some);
  EXPECT_TRUE(some->mesh.attributes.empty());
  const auto bytes = read_text("v 0 0 0 255 0 9\nv 1 0 0 1 2 3\nv 0 1 0 0 0 1\n" + face, FileFormat::kObj);
  ASSERT_TRUE(bytes);
  ASSERT_NE(find(bytes->mesh, AttributeKind::kColor), nullptr);
  EXPECT_EQ(numbers<std::uint8_t>(*find(bytes->mesh, AttributeKind::kColor))[2], 9);
  EXPECT_EQ(left_out(bytes->report, LeftOutKind::kGuesses), 3U);
}

TEST(ObjReader, CoordinatesAreReadToTheLastDigit) {
  const auto imported = read_text(
      "v 465000.123456 5120000.654321 0\nv 465001 5120001 nan\nv 465002.5 5120000 -inf 1.0\nf 1 2 3\n",
      FileFormat::kObj);
  ASSERT_TRUE(imported) << describe(imported.error());
  const Mesh& mesh = imported->mesh;
  EXPECT_NEAR(mesh.origin[1] + static_cast<double>(mesh.positions[1]), 5120000.654321, 1e-6);
  EXPECT_TRUE(std::isnan(mesh.positions[5]));
  EXPECT_EQ(mesh.positions[8], -INFINITY);
}

TEST(ObjReader, ErrorsNameTheirLine) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const FileFormat obj = FileFormat::kObj;
  expect_error("v 0 0\n", obj, WhereKind::kLine, 1);
  expect_error("\n\nv 0 zero 0\n", obj, WhereKind::kLine, 3);
  expect_error(vertices + "# comment\nf 1 2 4\n", obj, WhereKind::kLine, 5);
  expect_error(vertices + "f 1 2 0\n", obj, WhereKind::kLine, 4);
  expect_error(vertices + "f -4 2 1\n", obj, WhereKind::kLine, 4);
  expect_error(vertices + "f 1/1 2 3\n", obj, WhereKind::kLine, 4);
  expect_error(vertices + "f 1//2 2 3\n", obj, WhereKind::kLine, 4);
  expect_error(vertices + "f 1 2 4294967297\n", obj, WhereKind::kLine, 4);
  expect_robust(bytes_of(vertices + "vt 1 2\nvn 0 0 1\nf 1/1/1 2//1 3\\\n/1\nl 1 2\ng a b\nusemtl x\n"), obj);
}

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
  return "facet normal 0 0 1\nouter loop\nvertex " + a + "\nvertex " + b + "\nvertex " + c +
         "\nendloop\nendfacet\n";
}

TEST(StlReader, WeldsCornersByPosition) {
  const std::string text = "solid two words\n" + facet("0 0 0", "1 0 0", "0 1 0") +
                           facet("1 -0 0.0", "1e0 1 0", "-0 1 -0.0") + "endsolid two words\n";
  const auto imported = read_text(text, FileFormat::kStl);
  ASSERT_TRUE(imported) << describe(imported.error());
  EXPECT_EQ(imported->mesh.vertex_count(), 4U);
  EXPECT_EQ(imported->mesh.triangles, (std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2}));
  EXPECT_EQ(imported->report.welded_corners, 2U);
  expect_robust(bytes_of(text), FileFormat::kStl);
}

TEST(StlReader, WeldsWhatIsNotANumberByItsBits) {
  const std::string text = "solid\n" + facet("nan 0 0", "nan 0 0", "5 1 0") + "endsolid\n";
  const auto imported = read_text(text, FileFormat::kStl);
  ASSERT_TRUE(imported) << describe(imported.error());
  EXPECT_EQ(imported->mesh.triangles, (std::vector<std::uint32_t>{0, 0, 1}));
}

TEST(StlReader, SeveralSolidsUpperCaseAndNoName) {
  std::string text = "solid\n" + facet("0 0 0", "1 0 0", "0 1 0") + "endsolid\nsolid b\nendsolid b\n";
  for (char& c : text) c = static_cast<char>(std::toupper(c));
  const auto imported = read_text(text, FileFormat::kStl);
  ASSERT_TRUE(imported) << describe(imported.error());
  EXPECT_EQ(imported->mesh.triangle_count(), 1U);
}

TEST(StlReader, BinaryThatBeginsWithSolid) {
  const Mesh mesh = test::small_mesh();
  std::vector<std::byte> bytes = *write_mesh(mesh, FileFormat::kStl);
  const std::string title = "solid  exported as binary";
  for (std::size_t i = 0; i < title.size(); ++i) bytes[i] = static_cast<std::byte>(title[i]);
  const auto exact = read_exact(bytes, FileFormat::kStl);
  ASSERT_TRUE(exact) << describe(exact.error());
  EXPECT_EQ(exact->mesh.triangles, mesh.triangles);
  bytes.resize(bytes.size() + 7);
  const auto longer = read_exact(bytes, FileFormat::kStl);
  ASSERT_TRUE(longer) << describe(longer.error());
  EXPECT_EQ(longer->mesh.triangles, mesh.triangles);
}

TEST(StlReader, RefusesBrokenFiles) {
  const FileFormat stl = FileFormat::kStl;
  expect_error("", stl);
  expect_error("neither this nor that", stl);
  expect_error("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0\nvertex 1 0 0\n", stl, WhereKind::kLine,
               5);
  expect_error("solid a\nendsolid\nrubbish\n", stl, WhereKind::kLine, 3);
  std::string hostile(84, '\0');
  hostile.replace(80, 4, "\xff\xff\xff\xff");
  expect_error(hostile, stl, WhereKind::kByte, 84);
}

TEST(OffReader, CountsOnTheFirstLineCommentsAndFacesOverSeveralLines) {
  const auto imported = read_text(
      "OFF 5 3 0 # counts\n\n0 0 0\n1 0 0 # a comment\n1 1\n0\n# another\n0 1 0\n0.5 0.5 1\n"
      "4 0 1\n 2\n3 255 0 0\n3 0 1 4 0.5 0.5 0.5 1\n2 0 1\n",
      FileFormat::kOff);
  ASSERT_TRUE(imported) << describe(imported.error());
  EXPECT_EQ(imported->mesh.vertex_count(), 5U);
  EXPECT_EQ(imported->mesh.triangles, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3, 0, 1, 4}));
  EXPECT_EQ(imported->report.polygons, 1U);
  EXPECT_EQ(left_out(imported->report, LeftOutKind::kFaces), 1U);
}

TEST(OffReader, PrefixesPromiseAttributes) {
  const auto imported = read_text(
      "STCNOFF\n3 1\n0 0 0 0 0 1 255 0 7 0.5 1\n1 0 0 0 1 0 1 2 3 0 0\n0 1 0 1 0 0 4 5 6 1 1\n3 0 1 2\n",
      FileFormat::kOff);
  ASSERT_TRUE(imported) << describe(imported.error());
  const Mesh& mesh = imported->mesh;
  EXPECT_EQ(numbers<float>(*find(mesh, AttributeKind::kNormal)),
            (std::vector<float>{0, 0, 1, 0, 1, 0, 1, 0, 0}));
  EXPECT_EQ(numbers<std::uint8_t>(*find(mesh, AttributeKind::kColor)),
            (std::vector<std::uint8_t>{255, 0, 7, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(numbers<float>(*find(mesh, AttributeKind::kUv)), (std::vector<float>{0.5F, 1, 0, 0, 1, 1}));
  const auto real = read_text("COFF\n2 0 0\n0 0 0 0 0 1.0 1\n1 0 0 1 0 0.25 1\n", FileFormat::kOff);
  ASSERT_TRUE(real) << describe(real.error());
  EXPECT_EQ(numbers<float>(*find(real->mesh, AttributeKind::kColor)),
            (std::vector<float>{0, 0, 1, 1, 1, 0, 0.25F, 1}));
}

TEST(OffReader, RefusesBrokenFiles) {
  const FileFormat off = FileFormat::kOff;
  expect_error("", off);
  expect_error("4OFF\n1 0 0\n0 0 0 0\n", off, WhereKind::kLine, 1);
  expect_error("OFF BINARY\n", off, WhereKind::kLine, 1);
  expect_error("OFF\n4294967295 4294967295 0\n", off, WhereKind::kLine, 2);
  expect_error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", off, WhereKind::kLine, 6);
  expect_error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", off, WhereKind::kLine, 6);
  expect_error("COFF\n1 0 0\n0 0 0 1 2\n", off, WhereKind::kLine, 3);
  expect_error("NOFF\n1 0 0\n0 0 0 1\n", off, WhereKind::kLine, 3);
  expect_robust(bytes_of("STCNOFF 2 1 0\n0 0 0 0 0 1 2 3 4 0 1\n0 1 0 0 0 1 2 3 4 0 1\n3 0 1 0 9\n"), off);
}

}  // namespace
}  // namespace deltamesh
