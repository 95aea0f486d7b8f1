// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From parts to one mesh: attributes and shared vertices, wherever seams are.
#include "deltamesh/map/join.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <span>
#include <utility>

#include "deltamesh/compare.h"
#include "deltamesh/map/encode_map.h"
#include "deltamesh/map/split.h"
#include "map/map_meshes.h"

namespace deltamesh {
namespace {

using test::topology_counts;
using test::welded;

TEST(MapJoin, CopiesOfAVertexStayApartWhereAttributesDiffer) {
  MapPart a;
  a.mesh.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0};
  a.mesh.triangles = {0, 1, 2, 3, 2, 1};
  a.mesh.attributes = {{AttributeKind::kGeneric,
                        ComponentType::kU8,
                        1,
                        false,
                        "label",
                        {std::byte{1}, std::byte{0}, std::byte{0}, std::byte{2}}}};
  a.border = {{0, {0, 0, 0}, 0}, {3, {0, 0, 0}, 0}};
  MapPart b;
  b.mesh.positions = {0, 0, 0, -1, 0, 0, 0, -1, 0};
  b.mesh.triangles = {0, 1, 2};
  b.mesh.attributes = {{AttributeKind::kGeneric,
                        ComponentType::kU8,
                        1,
                        false,
                        "label",
                        {std::byte{2}, std::byte{0}, std::byte{0}}}};
  b.border = {{0, {0, 0, 0}, 0}};
  const auto joined = join(std::vector<MapPart>{a, b});
  ASSERT_TRUE(joined);
  EXPECT_EQ(joined->vertex_count(), 6U);
  EXPECT_EQ(joined->triangles, (std::vector<std::uint32_t>{0, 1, 2, 3, 2, 1, 3, 4, 5}));
}

/// `mesh` with labels that faces choose at random among a few; corners of one label share their vertex, so
/// that seams are everywhere.
Mesh with_label_seams(const Mesh& mesh, std::uint32_t seed) {
  std::mt19937 random(seed);
  Mesh seamed;
  Attribute labels{AttributeKind::kGeneric, ComponentType::kU8, 1, false, "label", {}};
  std::map<std::pair<std::uint32_t, std::byte>, std::uint32_t> numbers;
  for (std::size_t f = 0; f < mesh.triangle_count(); ++f) {
    const auto label = static_cast<std::byte>(random() % 8 == 0 ? 1 + random() % 2 : 0);
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t v = mesh.triangles[3 * f + c];
      const auto [number, is_new] =
          numbers.try_emplace({v, label}, static_cast<std::uint32_t>(seamed.vertex_count()));
      seamed.triangles.push_back(number->second);
      if (!is_new) continue;
      const float* p = mesh.positions.data() + 3 * std::size_t{v};
      seamed.positions.insert(seamed.positions.end(), p, p + 3);
      labels.values.push_back(label);
    }
  }
  seamed.attributes.push_back(std::move(labels));
  return seamed;
}

/// Of every face, in ascending order, its positions and labels.
std::vector<std::pair<test::FaceBits, std::byte>> labelled_faces(const Mesh& mesh) {
  std::vector<std::pair<test::FaceBits, std::byte>> faces;
  for (std::size_t f = 0; f < mesh.triangle_count(); ++f) {
    Mesh face;
    face.positions = mesh.positions;
    face.triangles.assign(mesh.triangles.begin() + 3 * f, mesh.triangles.begin() + 3 * f + 3);
    const std::byte label = mesh.attributes.front().values[face.triangles[0]];
    for (const std::uint32_t v : face.triangles) EXPECT_EQ(mesh.attributes.front().values[v], label);
    faces.emplace_back(test::face_bits(face).front(), label);
  }
  std::ranges::sort(faces);
  return faces;
}

TEST(MapJoin, SeamsAndSharedVerticesAreThoseOfTheSource) {
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = with_label_seams(test::wavy_sheet(20, 15, seed, 0), seed);
    const MapDescription description{.cell_steps = 37 + 40 * seed, .attributes = test::attributes_of(mesh)};
    const auto parts = split(mesh, description, {.most_triangles = 50});
    ASSERT_TRUE(parts);
    ASSERT_GT(parts->size(), 4U);
    const auto joined = join(*parts);
    ASSERT_TRUE(joined);
    EXPECT_EQ(labelled_faces(*joined), labelled_faces(mesh));
    EXPECT_EQ(topology_counts(*joined), topology_counts(mesh));
  }
}

template <std::size_t kComponents, class ValueOf>
Attribute attribute_of(AttributeKind kind, const char* name, std::span<const float> positions,
                       ValueOf value_of) {
  Attribute attribute{kind, ComponentType::kF32, kComponents, false, name, {}};
  for (std::size_t i = 0; i < positions.size(); i += 3) {
    const std::array<float, kComponents> value = value_of(i / 3, positions[i + 1]);
    const auto bytes = std::as_bytes(std::span(value));
    attribute.values.insert(attribute.values.end(), bytes.begin(), bytes.end());
  }
  return attribute;
}

/// A column of quads from x = 0 to 1 beside one from 1 to 2. With a seam all attributes jump between them.
Mesh two_columns(bool has_seam) {
  constexpr std::uint32_t kAcross = 4;  // two vertices of each column
  constexpr std::uint32_t kRows = 4;
  Mesh mesh;
  for (std::uint32_t row = 0; row <= kRows; ++row)
    for (const double x : {0, 1, 1, 2})
      for (const double coordinate : {x, 0.1 * row, 0.01 * row * row})
        mesh.positions.push_back(static_cast<float>(coordinate));
  for (std::uint32_t row = 0; row < kRows; ++row)
    for (const std::uint32_t left : {0U, has_seam ? 2U : 1U}) {
      const std::uint32_t a = kAcross * row + left;
      const std::uint32_t b = kAcross * row + (left == 0 ? 1 : 3);
      for (const std::uint32_t corner : {a, b, a + kAcross, b, b + kAcross, a + kAcross})
        mesh.triangles.push_back(corner);
    }
  const auto jumps = [has_seam](std::size_t v) { return has_seam && v % kAcross >= 2; };
  mesh.attributes = {attribute_of<3>(AttributeKind::kNormal, "normal", mesh.positions,
                                     [&](std::size_t v, float) -> std::array<float, 3> {
                                       return {jumps(v) ? 0.6F : 0.0F, 0, jumps(v) ? 0.8F : 1.0F};
                                     }),
                     attribute_of<4>(AttributeKind::kTangent, "tangent", mesh.positions,
                                     [&](std::size_t v, float) -> std::array<float, 4> {
                                       return {jumps(v) ? 0.8F : 1.0F, 0, jumps(v) ? -0.6F : 0.0F, 1};
                                     }),
                     attribute_of<2>(AttributeKind::kUv, "uv", mesh.positions,
                                     [&](std::size_t v, float y) -> std::array<float, 2> {
                                       return {jumps(v) ? 1.0F : 0.3F, y};
                                     }),
                     attribute_of<1>(AttributeKind::kGeneric, "height", mesh.positions,
                                     [&](std::size_t v, float y) -> std::array<float, 1> {
                                       return {jumps(v) ? -y : y + 1};
                                     })};
  return mesh;
}

TEST(MapJoin, AttributesKeepTheirBoundsWhereASeamIsABorder) {
  MapSettings settings{.part_edge = 1};
  settings.quality.bounds.max_error = QualityBound{0.001};
  for (const bool is_exact : {true, false}) {
    settings.quality.attributes = {.normal_error = is_exact ? 0 : 0.5, .uv_error = is_exact ? 0 : 0.001};
    if (!is_exact) settings.quality.attributes.named = {{.name = "height", .error = 0.01}};
    const std::array<double, 4> bounds = {0.5, 0.5, 0.001, 0.01};
    for (const bool has_seam : {true, false}) {
      const Mesh mesh = two_columns(has_seam);
      const auto state = encode_map(mesh, settings);
      ASSERT_TRUE(state) << describe(state.error());
      ASSERT_EQ(state->octets.size(), 2U);
      const auto joined = decode_map(*state);
      ASSERT_TRUE(joined);
      EXPECT_EQ(topology_counts(welded(*joined)), topology_counts(welded(mesh)));
      if (is_exact || has_seam) {
        EXPECT_EQ(topology_counts(*joined), topology_counts(mesh));
      }
      const auto comparison = compare(mesh, *joined);
      ASSERT_TRUE(comparison);
      for (std::size_t i = 0; i < bounds.size(); ++i)
        EXPECT_LE(comparison->attributes[i].max_error, is_exact ? 0 : bounds[i]) << mesh.attributes[i].name;
    }
  }
}

}  // namespace
}  // namespace deltamesh
