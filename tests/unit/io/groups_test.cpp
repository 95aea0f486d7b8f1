// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Groups of faces keep their names between OBJ, streams and glTF; what no file can hold is told.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "io_support.h"

namespace deltamesh::groups_test {
namespace {

using test::attribute;
using test::left_out;
using test::numbers;

const std::string kNamed =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 2 0 0\no table\nusemtl oak\nf 1 2 3\ng leg\nf 2 4 3\no "
    "lamp\nusemtl bra\xc3\xa7s\nf 2 5 4\n";

Mesh through_stream(const Mesh& mesh, const EncodeOptions& options) {
  const auto encoded = encode(mesh, options);
  EXPECT_TRUE(encoded);
  const auto decoded = decode(encoded->bytes);
  EXPECT_TRUE(decoded);
  return *decoded;
}

Mesh through_file(const Mesh& mesh, FileFormat format, WriteReport* report = nullptr) {
  const auto bytes = write_mesh(mesh, format, report);
  EXPECT_TRUE(bytes);
  const auto read = test::read_exact(*bytes, format);
  EXPECT_TRUE(read) << describe(read.error());
  return read->mesh;
}

/// Of every face its names, in the order of faces.
std::vector<GroupName> names_of_faces(const Mesh& mesh) {
  std::vector<GroupName> names;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
    names.push_back(mesh.group_names.at(mesh.face_groups.empty() ? 0 : mesh.face_groups[t]));
  return names;
}

TEST(Groups, NamesSurviveObjStreamsAndGltf) {
  const auto source = test::read_text(kNamed, FileFormat::kObj);
  ASSERT_TRUE(source);
  EXPECT_TRUE(source->report.left_out.empty());
  const std::vector<GroupName> names{
      {"table", "", "oak"}, {"table", "leg", "oak"}, {"lamp", "leg", "bra\xc3\xa7s"}};
  EXPECT_EQ(names_of_faces(source->mesh), names);
  for (const Profile profile : {Profile::kSmallest, Profile::kZstd}) {
    const Mesh decoded = through_stream(source->mesh, {.profile = profile, .keep_order = true});
    EXPECT_EQ(names_of_faces(decoded), names);
    for (const FileFormat format : {FileFormat::kObj, FileFormat::kGlb, FileFormat::kGltf}) {
      WriteReport report;
      EXPECT_EQ(names_of_faces(through_file(decoded, format, &report)), names);
      EXPECT_TRUE(report.left_out.empty());
    }
  }
}

TEST(Groups, OneNamedGroupKeepsItsName) {
  const auto source =
      test::read_text("v 0 0 0\nv 1 0 0\nv 0 1 0\no table\nusemtl oak\nf 1 2 3\n", FileFormat::kObj);
  ASSERT_TRUE(source);
  EXPECT_TRUE(source->mesh.face_groups.empty());
  const Mesh back = through_file(through_stream(source->mesh, {}), FileFormat::kGlb);
  EXPECT_EQ(names_of_faces(back), (std::vector<GroupName>{{"table", "", "oak"}}));
}

TEST(Groups, WithoutNamesOrWithEqualOnesStayApart) {
  Mesh mesh = test::small_mesh();
  mesh.face_groups = {4, 0, 4};
  for (const bool named : {false, true}) {
    if (named) mesh.group_names.assign(5, GroupName{"", "", "steel"});
    for (const FileFormat format : {FileFormat::kObj, FileFormat::kGlb}) {
      const Mesh back = through_file(mesh, format);
      ASSERT_EQ(back.face_groups.size(), 3U);
      std::vector<std::uint32_t> sorted = back.face_groups;  // primitives follow each other by group
      std::sort(sorted.begin(), sorted.end());
      EXPECT_NE(sorted[0], sorted[2]);
      EXPECT_EQ(names_of_faces(back).size(), 3U);
    }
  }
  mesh.group_names.clear();
  mesh.face_groups[1] = 1U << 16;
  EXPECT_FALSE(write_mesh(mesh, FileFormat::kObj));
}

TEST(Groups, GltfMaterialsThatDoNotExistHaveNoName) {
  constexpr int kPrimitives = 6;
  const std::string primitive = R"({"attributes":{"POSITION":0},"extras":{"group":"g"},"material":)";
  std::string primitives = R"({"attributes":{"POSITION":0},"extras":{"group":"g"}})";
  for (const char* material : {"0", "1", "4294967295", "18446744073709551614", "18446744073709551615"})
    primitives += ',' + primitive + material + '}';
  const auto read =
      test::read_text(R"({"asset":{"version":"2.0"},"materials":[{"name":"oak"}],"meshes":[{"primitives":[)" +
                          primitives + R"(]}],"accessors":[{"componentType":5126,"type":"VEC3","count":3}]})",
                      FileFormat::kGltf);
  ASSERT_TRUE(read) << describe(read.error());
  std::vector<GroupName> names(kPrimitives, GroupName{"", "g", ""});
  names[1].material = "oak";
  EXPECT_EQ(names_of_faces(read->mesh), names);
  EXPECT_EQ(read->mesh.face_groups, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
}

TEST(Groups, FormatsWithoutGroupsTell) {
  const auto source = test::read_text(kNamed, FileFormat::kObj);
  ASSERT_TRUE(source);
  for (const FileFormat format : {FileFormat::kPly, FileFormat::kOff, FileFormat::kStl}) {
    WriteReport report;
    ASSERT_TRUE(write_mesh(source->mesh, format, &report));
    EXPECT_EQ(left_out(report, LeftOutKind::kFaceValues, "groups"), 3U);
    EXPECT_EQ(left_out(report, LeftOutKind::kNames, "groups"), 3U);
  }
}

TEST(Groups, FGRP4OtherFormsOfTheChunkAreNoNames) {
  const auto source = test::read_text(kNamed, FileFormat::kObj);
  ASSERT_TRUE(source);
  Mesh mesh = source->mesh;
  mesh.group_names[0].object.assign(300, 'x');  // cut
  EXPECT_EQ(through_stream(mesh, {}).group_names[0].object.size(), 255U);
  mesh.group_names.assign(3, GroupName{});
  EXPECT_TRUE(through_stream(mesh, {}).group_names.empty());
}

TEST(Groups, GlbTakesIntegersAndDoublesAsCustomAttributes) {
  Mesh mesh = test::small_mesh();
  mesh.attributes = {
      attribute<std::int32_t>(AttributeKind::kGeneric, ComponentType::kI32, 1, "label", {0, -7, 300, 5}),
      attribute<std::int32_t>(AttributeKind::kGeneric, ComponentType::kI32, 1, "large",
                              {0, 1 << 20, 16777217, 5}),
      attribute<double>(AttributeKind::kGeneric, ComponentType::kF64, 2, "time",
                        {0.5, 0.25, 1e9, 0.1, 2, 3, 4, 5}),
      attribute<std::uint32_t>(AttributeKind::kGeneric, ComponentType::kU32, 1, "id", {0, 9, 255, 1})};
  WriteReport report;
  const Mesh back = through_file(mesh, FileFormat::kGlb, &report);
  ASSERT_EQ(back.attributes.size(), 4U);  // by name
  EXPECT_EQ(back.attributes[0].name, "_id");
  EXPECT_EQ(numbers<std::uint8_t>(back.attributes[0]), (std::vector<std::uint8_t>{0, 9, 255, 1}));
  EXPECT_EQ(numbers<std::int16_t>(back.attributes[1]), (std::vector<std::int16_t>{0, -7, 300, 5}));
  EXPECT_EQ(numbers<float>(back.attributes[2])[1], 1048576);
  EXPECT_EQ(numbers<float>(back.attributes[3])[2], 1e9F);
  EXPECT_EQ(left_out(report, LeftOutKind::kPrecision, "large"), 1U);
  EXPECT_EQ(left_out(report, LeftOutKind::kPrecision, "time"), 1U);
  EXPECT_EQ(report.left_out.size(), 2U);
}

TEST(Groups, DoublePropertiesAreToldWhereFloatsDoNotHoldThem) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double "
      "z\nproperty double nx\n"
      "property double ny\nproperty double nz\nelement face 1\nproperty list uchar int "
      "vertex_indices\nend_header\n"
      "0.1 0 0 0 0 1\n1 0 0 0.1 0 1\n0 1 0 0.1 0.5 1\n3 0 1 2\n";
  const auto read = test::read_text(ply, FileFormat::kPly);
  ASSERT_TRUE(read);
  EXPECT_EQ(left_out(read->report, LeftOutKind::kPrecision, "nx"), 2U);
  EXPECT_EQ(left_out(read->report, LeftOutKind::kPrecision), 2U);
  EXPECT_NEAR(read->report.position_error, 0.1F - 0.1, 1e-12);
}

}  // namespace
}  // namespace deltamesh::groups_test
