// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Nothing is lost in silence: what readers keep of corners and faces, and what reports list.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "io_support.h"

namespace deltamesh::left_out_test {
namespace {

using test::attribute;
using test::find;
using test::left_out;
using test::numbers;

using Groups = std::vector<std::uint32_t>;

Imported read(const std::string& text, FileFormat format) {
  auto imported = test::read_text(text, format);
  EXPECT_TRUE(imported) << describe(imported.error());
  if (!imported) return {};
  test::expect_valid(imported->mesh);
  return *std::move(imported);
}

/// Values of an attribute at the corners of all triangles.
template <class T>
std::vector<T> at_corners(const Mesh& mesh, AttributeKind kind) {
  std::vector<T> result;
  const Attribute* const found = find(mesh, kind);
  if (found == nullptr) return result;
  const auto values = numbers<T>(*found);
  for (const std::uint32_t v : mesh.triangles)
    result.insert(result.end(), &values[v * found->components],
                  &values[v * found->components] + found->components);
  return result;
}

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";

TEST(LeftOut, ObjNormalsColorsAndTextureCoordinatesOnSome) {
  const Imported normals = read(kSquare + "vn 0 0 1\nf 1//1 2//1 3//1\nf 2 4 3\n", FileFormat::kObj);
  EXPECT_TRUE(normals.mesh.attributes.empty());
  EXPECT_EQ(left_out(normals.report, LeftOutKind::kFaceValues), 3U);
  const Imported corner = read(kSquare + "vn 0 0 1\nf 1//1 2//1 3\n", FileFormat::kObj);
  EXPECT_EQ(left_out(corner.report, LeftOutKind::kFaceValues), 2U);
  const Imported colors = read("v 5 5 5 1 0 0\n" + kSquare + "f 2 3 4\n", FileFormat::kObj);
  EXPECT_TRUE(colors.mesh.attributes.empty());
  EXPECT_EQ(left_out(colors.report, LeftOutKind::kVertexValues), 1U);
  const Imported uvs = read(kSquare + "vt 1 1\nvt 2 2 3\nf 1/1 2/1 3/2\nf 2 4 3\n", FileFormat::kObj);
  EXPECT_EQ(at_corners<float>(uvs.mesh, AttributeKind::kUv),
            (std::vector<float>{1, 1, 1, 1, 2, 2, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(left_out(uvs.report, LeftOutKind::kGuesses), 3U);
  EXPECT_EQ(left_out(uvs.report, LeftOutKind::kFaceValues, "third texture coordinates"), 1U);
}

TEST(LeftOut, ObjGroupsAndMaterialsBecomeFaceGroups) {
  const Imported both = read(
      "mtllib x.mtl\no one\ng left\nusemtl red\n" + kSquare +
          "f 1 2 3\no two\ng right\nusemtl blue\ns 1\nf 2 4 3\nusemtl red\nf 1 3 2\no one\ng left\nf 1 2 4\n",
      FileFormat::kObj);
  EXPECT_EQ(both.mesh.face_groups, (Groups{0, 1, 2, 0}));
  EXPECT_EQ(left_out(both.report, LeftOutKind::kNames), 0U);
  EXPECT_EQ(
      both.mesh.group_names,
      (std::vector<GroupName>{{"one", "left", "red"}, {"two", "right", "blue"}, {"two", "right", "red"}}));
  EXPECT_EQ(left_out(both.report, LeftOutKind::kElements, "smoothing groups"), 1U);
  EXPECT_EQ(left_out(both.report, LeftOutKind::kElements, "mtllib"), 1U);
  EXPECT_TRUE(read("o one\ng a b\n" + kSquare + "f 1 2 3\n", FileFormat::kObj).mesh.face_groups.empty());
  // Polygons of several triangles, and groups without faces.
  EXPECT_EQ(read(kSquare + "g none\ng a\nf 1 2 4 3\ng b\nf 1 2 3\n", FileFormat::kObj).mesh.face_groups,
            (Groups{0, 0, 1}));
  // They survive to OBJ, and are told where they do not.
  WriteReport report;
  const auto obj = write_mesh(both.mesh, FileFormat::kObj, &report);
  ASSERT_TRUE(obj);
  EXPECT_TRUE(report.left_out.empty());
  EXPECT_EQ(read(test::text_of(*obj), FileFormat::kObj).mesh.face_groups, both.mesh.face_groups);
  for (const FileFormat format : {FileFormat::kPly, FileFormat::kOff, FileFormat::kStl}) {
    WriteReport losses;
    ASSERT_TRUE(write_mesh(both.mesh, format, &losses));
    EXPECT_EQ(left_out(losses, LeftOutKind::kFaceValues, "groups"), 4U);
  }
}

TEST(LeftOut, ObjOtherStatements) {
  const Imported imported =
      read(kSquare + "f 1 2 3\nl 1 2\np 1\nvp 1 1\nv 1 1 1 0.5\ns off\n", FileFormat::kObj);
  EXPECT_EQ(left_out(imported.report, LeftOutKind::kPrimitives, "lines"), 1U);
  EXPECT_EQ(left_out(imported.report, LeftOutKind::kPrimitives, "points"), 1U);
  EXPECT_EQ(left_out(imported.report, LeftOutKind::kElements, "vp"), 1U);
  EXPECT_EQ(left_out(imported.report, LeftOutKind::kVertexValues, "weights"), 1U);
  EXPECT_EQ(imported.report.left_out.size(), 4U);
  test::expect_error(kSquare + "ff 1 2 3\n", FileFormat::kObj, WhereKind::kLine, 5);
}

const std::string kPlyHead =
    "ply\nformat ascii 1.0\ncomment TextureFile map.png\nelement vertex 4\nproperty float x\nproperty float "
    "y\n"
    "property float z\nelement face 2\nproperty list uchar int vertex_indices\n";
const std::string kPlyRows = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n";

TEST(LeftOut, PlyFacesHaveColorsAndTextureCoordinates) {
  const Imported imported =
      read(kPlyHead +
               "property list uchar float texcoord\nproperty int texnumber\nproperty uchar red\nproperty "
               "uchar green\n"
               "property uchar blue\nproperty uchar alpha\nend_header\n" +
               kPlyRows + "3 0 1 2 6 0 0 1 0 0 1 0 255 0 0 255\n3 1 3 2 6 1 0 .6 .5 .5 .6 1 255 0 0 255\n",
           FileFormat::kPly);
  EXPECT_EQ(at_corners<float>(imported.mesh, AttributeKind::kUv),
            (std::vector<float>{0, 0, 1, 0, 0, 1, 1, 0, .6F, .5F, .5F, .6F}));
  EXPECT_EQ(at_corners<std::uint8_t>(imported.mesh, AttributeKind::kColor)[3], 255);
  EXPECT_EQ(imported.mesh.vertex_count(), 5U);  // split at one of two corners that the triangles share
  EXPECT_EQ(left_out(imported.report, LeftOutKind::kFaceValues, "texnumber"), 2U);
  EXPECT_EQ(left_out(imported.report, LeftOutKind::kElements, "TextureFile"), 1U);
  EXPECT_EQ(imported.report.left_out.size(), 2U);
}

TEST(LeftOut, PlyTextureCoordinatesOnSomeAndColorsOfVerticesToo) {
  const Imported imported = read(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
      "z\nproperty uchar red\n"
      "property uchar green\nproperty uchar blue\nproperty list uchar int near\nelement face 2\nproperty "
      "uchar red\n"
      "property uchar green\nproperty uchar blue\nproperty list uchar int vertex_index\nproperty list uchar "
      "float texcoord\n"
      "element material 1\nproperty int a\nend_header\n"
      "0 0 0 1 2 3 0\n1 0 0 1 2 3 0\n0 1 0 1 2 3 0\n9 9 9 3 0 1 2 6 1 1 1 1 1 1\n9 9 9 3 0 2 1 0\n7\n",
      FileFormat::kPly);
  EXPECT_EQ(at_corners<std::uint8_t>(imported.mesh, AttributeKind::kColor)[0], 1);
  EXPECT_EQ(left_out(imported.report, LeftOutKind::kFaceValues), 2U);
  EXPECT_EQ(left_out(imported.report, LeftOutKind::kVertexValues, "near"), 3U);
  EXPECT_EQ(left_out(imported.report, LeftOutKind::kGuesses), 3U);
  EXPECT_EQ(left_out(imported.report, LeftOutKind::kElements, "material"), 1U);
}

TEST(LeftOut, OffFacesHaveColors) {
  const std::string head = "OFF 4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n";
  const Imported bytes = read(head + "3 0 1 2 255 0 9\n3 1 3 2 0 0 7\n", FileFormat::kOff);
  EXPECT_EQ(at_corners<std::uint8_t>(bytes.mesh, AttributeKind::kColor),
            (std::vector<std::uint8_t>{255, 0, 9, 255, 0, 9, 255, 0, 9, 0, 0, 7, 0, 0, 7, 0, 0, 7}));
  EXPECT_EQ(read(head + "3 0 1 2 1.0 0 0 1\n3 1 3 2 1.0 0 0 1\n", FileFormat::kOff).mesh.vertex_count(), 4U);
  const Imported some = read(head + "3 0 1 2 255 0 9\n3 1 3 2\n", FileFormat::kOff);
  EXPECT_EQ(left_out(some.report, LeftOutKind::kFaceValues), 1U);
  EXPECT_TRUE(some.mesh.attributes.empty());
  EXPECT_EQ(
      left_out(read(head + "3 0 1 2 5\n3 1 3 2 5\n", FileFormat::kOff).report, LeftOutKind::kFaceValues), 2U);
}

std::string stl(const std::string& title, const std::vector<std::uint16_t>& attributes) {
  std::string header = title;
  header.resize(80, ' ');
  const auto count = static_cast<std::uint32_t>(attributes.size());
  std::string text = header + std::string(reinterpret_cast<const char*>(&count), 4);
  for (const std::uint16_t attribute : attributes) {
    const std::array<float, 12> values{0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    text.append(reinterpret_cast<const char*>(values.data()), sizeof values);
    text.append(reinterpret_cast<const char*>(&attribute), 2);
  }
  return text;
}

TEST(LeftOut, ObjNamesALibraryOnceHoweverOftenItIsGiven) {
  const Imported given = read(
      "mtllib a b.mtl\nmtllib b.mtl\nmtllib a b.mtl\nmtllib a\n" + kSquare + "f 1 2 3\n", FileFormat::kObj);
  EXPECT_EQ(given.report.files, (std::vector<std::string>{"a", "b.mtl", "a b.mtl"}));
  EXPECT_EQ(left_out(given.report, LeftOutKind::kElements, "mtllib"), 4U);
}

TEST(LeftOut, StlSolidsBecomeFaceGroups) {
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
  const Imported three = read("solid Left  Side\n" + facet + facet + "endsolid Left Side\nsolid\n" + facet +
                                  "endsolid\nsolid right " + facet + "endsolid right\n",
                              FileFormat::kStl);
  EXPECT_EQ(three.mesh.face_groups, (Groups{0, 0, 1, 2}));
  EXPECT_EQ(three.mesh.group_names,
            (std::vector<GroupName>{{.object = "Left Side"}, {}, {.object = "right"}}));
  EXPECT_TRUE(three.report.left_out.empty());
  const Imported one = read("solid a\n" + facet + "endsolid a\n", FileFormat::kStl);
  EXPECT_TRUE(one.mesh.face_groups.empty());
  EXPECT_TRUE(one.mesh.group_names.empty()) << "a title of the file";
  const Imported wrong = read("solid \xff\n" + facet + "endsolid\n", FileFormat::kStl);
  EXPECT_EQ(left_out(wrong.report, LeftOutKind::kNames), 1U);
}

TEST(LeftOut, StlFacetsHaveColorsOfTwoConventions) {
  using Bytes = std::vector<std::uint8_t>;
  const Mesh viscam = read(stl("x", {0x8000 | 31 << 10, 0x8000 | 16}), FileFormat::kStl).mesh;
  const Bytes red_blue = at_corners<std::uint8_t>(viscam, AttributeKind::kColor);
  EXPECT_EQ(Bytes(red_blue.begin(), red_blue.begin() + 3), (Bytes{255, 0, 0}));
  EXPECT_EQ(Bytes(red_blue.end() - 3, red_blue.end()), (Bytes{0, 0, 132}));
  const Mesh magics = read(stl("COLOR=\x09\x08\x07\xff", {31, 0x8000}), FileFormat::kStl).mesh;
  const Bytes own_other = at_corners<std::uint8_t>(magics, AttributeKind::kColor);
  EXPECT_EQ(Bytes(own_other.begin(), own_other.begin() + 3), (Bytes{255, 0, 0}));
  EXPECT_EQ(Bytes(own_other.end() - 3, own_other.end()), (Bytes{9, 8, 7}));
  EXPECT_EQ(left_out(read(stl("x", {0x8001, 0}), FileFormat::kStl).report, LeftOutKind::kFaceValues), 1U);
  EXPECT_EQ(
      left_out(read(stl("x", {7, 7}), FileFormat::kStl).report, LeftOutKind::kFaceValues, "attribute bytes"),
      2U);
}

TEST(LeftOut, WritersTellWhatTheyCannotHold) {
  Mesh mesh = test::dressed_mesh();
  mesh.attributes.push_back(
      attribute<std::int32_t>(AttributeKind::kGeneric, ComponentType::kI32, 1, "label", {1, 2, 3, 4}));
  mesh.attributes.push_back(
      attribute<double>(AttributeKind::kGeneric, ComponentType::kF64, 1, "a time", {1, 2, 3, 4}));
  mesh.origin = {0.1, 0, 0};
  const auto report_of = [&](FileFormat format) {
    WriteReport report;
    EXPECT_TRUE(write_mesh(mesh, format, &report));
    return report;
  };
  EXPECT_EQ(left_out(report_of(FileFormat::kPly), LeftOutKind::kNames, "a time"), 1U);
  EXPECT_EQ(report_of(FileFormat::kPly).left_out.size(), 1U);
  for (const FileFormat format : {FileFormat::kObj, FileFormat::kOff, FileFormat::kStl})
    EXPECT_EQ(left_out(report_of(format), LeftOutKind::kVertexValues, "label"), 4U);
  EXPECT_EQ(left_out(report_of(FileFormat::kObj), LeftOutKind::kVertexValues, "alpha"), 4U);
  EXPECT_EQ(report_of(FileFormat::kOff).left_out.size(), 2U);
  EXPECT_EQ(left_out(report_of(FileFormat::kStl), LeftOutKind::kVertexValues), 20U);
  EXPECT_EQ(left_out(report_of(FileFormat::kStl), LeftOutKind::kPrecision), 4U);
  mesh.triangles = {0, 1, 2};
  EXPECT_EQ(left_out(report_of(FileFormat::kStl), LeftOutKind::kElements), 1U);
}

}  // namespace
}  // namespace deltamesh::left_out_test
