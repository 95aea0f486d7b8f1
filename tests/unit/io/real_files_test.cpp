// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Files as other programs write them: each test is a kind of input, in several formats.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "io_support.h"

namespace deltamesh::real_files_test {
namespace {

using test::expect_error;
using test::find;
using test::left_out;
using test::numbers;
using test::read_text;

constexpr FileFormat kPly = FileFormat::kPly;
constexpr FileFormat kObj = FileFormat::kObj;
constexpr FileFormat kOff = FileFormat::kOff;
constexpr FileFormat kStl = FileFormat::kStl;

Imported read(const std::string& text, FileFormat format) {
  auto imported = read_text(text, format);
  EXPECT_TRUE(imported) << describe(imported.error()) << "\n" << text.substr(0, 300);
  if (!imported) return {};
  test::expect_valid(imported->mesh);
  return *std::move(imported);
}

/// The error's text, all of it.
std::string error_of(const std::string& text, FileFormat format) {
  const auto imported = read_text(text, format);
  EXPECT_FALSE(imported) << text.substr(0, 300);
  return imported ? "" : describe(imported.error());
}

const std::string kObjPoints = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string kObjFace = kObjPoints + "f 1 2 3\n";
const std::string kOffFace = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string kPlyHead =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement "
    "face 1\n"
    "property list uchar int vertex_indices\nend_header\n";
const std::string kPlyFace = kPlyHead + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string kFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
const std::string kStlFace = "solid x\n" + kFacet + "endsolid x\n";

const std::vector<std::pair<FileFormat, std::string>> kTexts{
    {kObj, kObjFace}, {kOff, kOffFace}, {kPly, kPlyFace}, {kStl, kStlFace}};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

TEST(RealFiles, ByteOrderMarkLineEndsBlanksAndZerosInEveryTextFormat) {
  for (const auto& [format, text] : kTexts) {
    const std::vector<std::uint32_t> triangle{0, 1, 2};
    const std::string half = replaced(text.substr(text.size() / 2), "\n", "\r\n");
    for (const std::string& variant :
         {"\xef\xbb\xbf" + text, replaced(text, "\n", "\r\n"), replaced(text, "\n", "\r"),
          replaced(text, "\n", " \t\n"), text.substr(0, text.size() / 2) + half, text + std::string(9, '\0'),
          text.substr(0, text.size() - 1)}) {
      const Imported imported = read(variant, format);
      EXPECT_EQ(imported.mesh.triangles, triangle);
      EXPECT_EQ(imported.mesh.positions, (std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}));
      EXPECT_TRUE(imported.report.left_out.empty());
    }
  }
}

TEST(RealFiles, WhatIsNoNumberIsRefusedWithLineAndText) {
  EXPECT_EQ(error_of("v 0 0 -1.#IND\n" + kObjFace, kObj),
            "OBJ: not a number, or one that does not fit a double: '-1.#IND', line 1");
  EXPECT_EQ(error_of(replaced(kOffFace, "1 0 0\n", "1 0 1.#QNAN\n"), kOff),
            "not a number, or one that does not fit a double: '1.#QNAN', line 4");
  for (const std::string wrong :
       {"1,5", "0x1p3", "1..2", "+-1", "--1", "1e", "1e999", "one", "1f", "1;", "1#"}) {
    for (const auto& [format, text] : kTexts) {
      const std::string changed = replaced(text, "1 0 0", "1 0 " + wrong);
      const auto imported = read_text(changed, format);
      ASSERT_FALSE(imported) << changed;
      EXPECT_EQ(imported.error().where_kind, WhereKind::kLine);
      EXPECT_EQ(std::string(imported.error().found.data()), wrong);
    }
  }
  for (const std::string right : {"1e-999", "+1", "1.", ".5", "-0", "1E+2", "nan", "-inf"})
    for (const auto& [format, text] : kTexts) read(replaced(text, "1 0 0", "1 0 " + right), format);
}

TEST(RealFiles, ObjCornersWithEmptyIndices) {
  for (const std::string face : {"f 1/ 2/ 3/", "f 1// 2// 3//", "f 1 2/ 3//", "f -3/ -2// -1"})
    EXPECT_EQ(read(kObjPoints + "vt 0 0\nvn 0 0 1\n" + face + "\n", kObj).mesh.triangles,
              (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_NE(find(read(kObjPoints + "vt 0 0\nf 1/1/ 2/1/ 3/1/\n", kObj).mesh, AttributeKind::kUv), nullptr);
  EXPECT_NE(find(read(kObjPoints + "vn 0 0 1\nf 1//1 2//1 3//1\n", kObj).mesh, AttributeKind::kNormal),
            nullptr);
  for (const std::string face :
       {"f /1 2 3", "f 1/1/1/1 2 3", "f 1 2 3x", "f 1 2 3.0", "f 1/x 2 3", "f 1 2 3 |"})
    expect_error(kObjPoints + "vt 0 0\nvn 0 0 1\n" + face + "\n", kObj, WhereKind::kLine, 6);
}

TEST(RealFiles, CommentsAnywhere) {
  EXPECT_EQ(read(kObjPoints + "f 1 2 3 # c\n", kObj).mesh.triangle_count(), 1U);
  EXPECT_EQ(read("#\n\t# x\\\nv 0 0 0 # 1 2 3\nv 1 0 0 #\nv 0 1 0\nusemtl a#b # c\nf -3 -2 \\\n -1 #", kObj)
                .mesh.triangle_count(),
            1U);
  EXPECT_EQ(
      read("# first\nOFF # magic\n# between\n3 1 0 # counts\n0 0 0 # a\n1 0 0\n#\n0 1 0\n3 0 1 2 # f\n# end",
           kOff)
          .mesh.triangle_count(),
      1U);
  EXPECT_EQ(read(replaced(kPlyFace, "element face", "comment 1 2 3\nobj_info\nelement face"), kPly)
                .mesh.triangle_count(),
            1U);
}

TEST(RealFiles, ConcavePolygonsKeepTheirAreaInEveryFormatThatHasThem) {
  const std::vector<std::string> points{"0 0 0", "10 0 0", "10 10 0", "9 10 0",
                                        "9 1 0", "1 1 0",  "1 10 0",  "0 10 0"};
  std::string obj;
  std::string rows;
  for (const std::string& point : points) {
    obj += "v " + point + "\n";
    rows += point + "\n";
  }
  const std::string face = "8 0 1 2 3 4 5 6 7\n";
  for (const Imported& imported :
       {read(obj + "f 1 2 3 4 5 6 7 8\n", kObj), read("OFF 8 1 0\n" + rows + face, kOff),
        read(replaced(kPlyHead, "vertex 3", "vertex 8") + rows + face, kPly)}) {
    double area = 0;
    const Mesh& mesh = imported.mesh;
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
      const float* const a = &mesh.positions[3 * mesh.triangles[t]];
      const float* const b = &mesh.positions[3 * mesh.triangles[t + 1]];
      const float* const c = &mesh.positions[3 * mesh.triangles[t + 2]];
      area +=
          std::fabs(static_cast<double>((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))) / 2;
    }
    EXPECT_EQ(area, 28);
    EXPECT_EQ(imported.report.polygons, 1U);
  }
}

std::string binary_stl(std::uint32_t stated, std::size_t facets, std::uint16_t attribute = 0,
                       std::string header = "x") {
  header.resize(80, ' ');
  std::string text = header + std::string(reinterpret_cast<const char*>(&stated), 4);
  for (std::size_t f = 0; f < facets; ++f) {
    const std::array<float, 12> values{0, 0, 1, 0, 0, static_cast<float>(f), 1, 0, 0, 0, 1, 0};
    text.append(reinterpret_cast<const char*>(values.data()), sizeof values);
    text.append(reinterpret_cast<const char*>(&attribute), 2);
  }
  return text;
}

TEST(RealFiles, SizeOfABinaryStlCountsMoreThanItsNumberOfFacets) {
  for (const std::uint32_t stated : {0U, 2U, 0xffffffffU}) {
    const Imported imported = read(binary_stl(stated, 4), kStl);
    EXPECT_EQ(imported.mesh.triangle_count(), 4U);
    EXPECT_EQ(left_out(imported.report, LeftOutKind::kGuesses), 4U);
  }
  EXPECT_TRUE(read(binary_stl(4, 4), kStl).report.left_out.empty());
  EXPECT_EQ(left_out(read(binary_stl(4, 4) + "\r\n", kStl).report, LeftOutKind::kElements), 2U);
  expect_error(binary_stl(5, 4), kStl);           // cut off
  expect_error(binary_stl(3, 4) + "\r\n", kStl);  // neither
  expect_error(binary_stl(0xffffffff, 0), kStl);  // nothing at all
}

TEST(RealFiles, TextStlByWordsAndNumbersAlone) {
  const std::string line = replaced(kFacet, "\n", " ");
  for (const std::string& text :
       {"solid x\n" + line + "\n" + line + "endsolid x\n", "solid a b c " + line + line + " endsolid a b c",
        "solid\n" + line + "endsolid\nsolid y\n" + line + "endsolid y",
        "SOLID facet\n" + replaced(kFacet + kFacet, "facet", "FACET"), "solid x\n" + kFacet + kFacet}) {
    const Imported imported = read(text, kStl);
    EXPECT_EQ(imported.mesh.triangle_count(), 2U) << text;
    const bool ends = text.find("endsolid") != text.npos;
    EXPECT_EQ(left_out(imported.report, LeftOutKind::kGuesses), ends ? 0U : 1U);
  }
  EXPECT_EQ(
      read(replaced(kStlFace, "normal 0 0 1", "normal -1.#IND -1.#IND -1.#IND"), kStl).mesh.triangle_count(),
      1U);
  expect_error("solid x\n" + kFacet + "facet normal 0 0 1 outer loop vertex 0 0 0", kStl);
  expect_error(replaced(kStlFace, "vertex 1 0 0", "vertex 1 0"), kStl, WhereKind::kLine, 6);
}

TEST(RealFiles, OffCountsBehindTheMagic) {
  const std::string rows = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const std::string head :
       {"OFF3 1 0\n", "OFF 3 1 0\n", "OFF\r\n3 1\n", "OFF3 1\n", "\n# x\nOFF\n\n3 1 0\n"})
    EXPECT_EQ(read(head + rows, kOff).mesh.triangle_count(), 1U) << head;
  EXPECT_EQ(read("COFF3 1 0\n0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 2 3\n3 0 1 2\n", kOff).mesh.attributes.size(),
            1U);
  EXPECT_EQ(read("NCOFF3 1 0\n0 0 0 0 0 1 1 2 3\n1 0 0 0 0 1 1 2 3\n0 1 0 0 0 1 1 2 3\n3 0 1 2\n", kOff)
                .mesh.attributes.size(),
            2U);
  for (const std::string head :
       {"OFFx 3 1 0\n", "OFF 3 1 0 0\n", "OFF 3.0 1 0\n", "OFF3 -1 0\n", "OFF 3 1 x\n"})
    expect_error(head + rows, kOff);
  expect_error("OFF 3 1 0\n" + rows + "3 0 1 2\n", kOff, WhereKind::kLine, 6);
}

TEST(RealFiles, VerticesThatAreNotFinite) {
  const std::vector<std::pair<FileFormat, std::string>> unused{
      {kObj, "v nan nan nan\n" + kObjPoints + "f 2 3 4\n"},
      {kOff, "OFF 4 1 0\nnan 0 0\n0 0 0\n1 0 0\n0 1 0\n3 1 2 3\n"},
      {kPly, replaced(kPlyHead, "vertex 3", "vertex 4") + "inf 0 0\n0 0 0\n1 0 0\n0 1 0\n3 1 2 3\n"}};
  for (const auto& [format, text] : unused) {
    const Imported imported = read(text, format);
    EXPECT_EQ(imported.mesh.positions, (std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}));
    EXPECT_EQ(imported.mesh.triangles, (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(left_out(imported.report, LeftOutKind::kElements), 1U);
  }
  const std::string used = "v nan 0 0\n" + kObjPoints + "f 1 2 3\nf 2 3 4\ng b\nf 3 2 4\n";
  EXPECT_TRUE(std::isnan(read(used, kObj).mesh.positions[0]));
  const auto dropped = read_mesh(std::as_bytes(std::span(used)), kObj, {}, {.drop_invalid = true});
  ASSERT_TRUE(dropped);
  EXPECT_EQ(dropped->mesh.triangles, (std::vector<std::uint32_t>{0, 1, 2, 1, 0, 2}));
  EXPECT_EQ(dropped->mesh.face_groups, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(left_out(dropped->report, LeftOutKind::kFaces), 1U);
}

}  // namespace
}  // namespace deltamesh::real_files_test
