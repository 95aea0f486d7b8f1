// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Committed streams decode to committed vertices and faces, whatever this build's encoder writes.
// `golden_test --update_golden` rewrites them: only on purpose, with a new draft number.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "deltamesh/io.h"
#include "scenes.h"
#include "support/meshes.h"

namespace deltamesh {
namespace {

bool update_golden = false;

struct Golden {
  const char* name;  ///< tests/golden/<name>.v1d13.dmsh and .off
  Mesh mesh;
  EncodeOptions options;
};

/// A rough surface with smooth colours: no repetition for zstd, neighbourhoods for the compact coder.
Mesh rough_grid() {
  Mesh mesh = testing::attributed_grid(40, 30);
  std::uint32_t state = 1;
  const auto noise = [&state] { return (state = state * 1664525 + 1013904223) >> 28; };
  for (float& x : mesh.positions) x += static_cast<float>(noise()) / 64;
  for (const std::size_t a : {std::size_t{1}, std::size_t{3}}) {
    Attribute& attribute = mesh.attributes[a];
    const std::size_t row = attribute.values.size() / mesh.vertex_count();
    for (std::size_t i = 0; i < attribute.values.size(); ++i) {
      const std::size_t v = i / row;
      attribute.values[i] = static_cast<std::byte>((v % 41) * (v / 41) / 5 + noise() / 4);
    }
  }
  return mesh;
}

template <class T>
Attribute attribute_of(AttributeKind kind, ComponentType type, int components, const char* name,
                       const std::vector<T>& numbers) {
  Attribute attribute{
      .kind = kind, .type = type, .components = static_cast<std::uint8_t>(components), .name = name};
  const auto bytes = std::as_bytes(std::span(numbers));
  attribute.values.assign(bytes.begin(), bytes.end());
  return attribute;
}

/// One of every kind of attribute that assets have, and two groups of faces.
Mesh asset() {
  Mesh mesh = testing::bumpy_grid(20, 15);
  std::vector<float> normals;
  std::vector<float> tangents;
  std::vector<float> uvs;
  std::vector<std::uint8_t> colors;
  std::vector<std::uint8_t> joints;
  std::vector<float> weights;
  std::vector<float> moves;
  std::vector<std::uint32_t> labels;
  for (std::uint32_t i = 0; i < mesh.vertex_count(); ++i) {
    const float x = mesh.positions[3 * i];
    const float y = mesh.positions[3 * i + 1];
    const float slope = 0.25F * static_cast<float>(i % 7) - 0.5F;
    const float size = std::sqrt(1 + slope * slope);
    normals.insert(normals.end(), {slope / size, 0, 1 / size});
    tangents.insert(tangents.end(), {1 / size, 0, -slope / size, i % 50 == 0 ? -1.0F : 1.0F});
    uvs.insert(uvs.end(), {x / 20 + 0.001F * static_cast<float>(i % 5), y / 15});
    colors.insert(colors.end(), {static_cast<std::uint8_t>(9 * x), static_cast<std::uint8_t>(11 * y),
                                 static_cast<std::uint8_t>(i * 37), static_cast<std::uint8_t>(255 - i % 3)});
    const auto bone = static_cast<std::uint8_t>(x / 4);
    joints.insert(joints.end(), {bone, static_cast<std::uint8_t>(bone + 1), 0, 0});
    const float share = static_cast<float>(i % 9) / 8;
    weights.insert(weights.end(), {share, 1 - share, 0, 0});
    moves.insert(moves.end(), {0, y > 7 ? 0.125F * slope : 0, 0});
    labels.push_back(i % 60 < 40 ? 70000 : 12);
  }
  using enum AttributeKind;
  using enum ComponentType;
  mesh.attributes = {attribute_of(kTangent, kF32, 4, "TANGENT", tangents),
                     attribute_of(kNormal, kF32, 3, "NORMAL", normals),
                     attribute_of(kUv, kF32, 2, "TEXCOORD_0", uvs),
                     attribute_of(kColor, kU8, 4, "COLOR_0", colors),
                     attribute_of(kJoints, kU8, 4, "JOINTS_0", joints),
                     attribute_of(kWeights, kF32, 4, "WEIGHTS_0", weights),
                     attribute_of(kGeneric, kF32, 3, "move", moves),
                     attribute_of(kGeneric, kU32, 1, "label", labels)};
  for (std::size_t f = 0; f < mesh.triangle_count(); ++f) mesh.face_groups.push_back(f < 200 ? 0 : 3);
  return mesh;
}

std::vector<Golden> golden_streams() {
  std::vector<Golden> list;
  list.push_back({"tetrahedron.default", testing::tetrahedron(), {}});
  list.push_back({"grid.bits6", testing::bumpy_grid(12, 10), {.bits = 6, .anchors = 4}});
  list.push_back(
      {"grid.zstd", testing::bumpy_grid(12, 10), {.bits = 6, .anchors = 4, .profile = Profile::kZstd}});
  list.push_back({"attributes.compact", rough_grid(), {.bits = 8}});
  list.push_back({"attributes.zstd",
                  testing::attributed_grid(6, 5),
                  {.bits = 10, .profile = Profile::kZstd, .keep_order = true}});
  list.push_back({"grid.predictive", rough_grid(), {.geometry = GeometryCoder::kPredictive, .bits = 11}});
  list.push_back({"asset.bounded", asset(), {.attributes = {.color_error = 3, .named = {{"move", 0.01}}}}});
  list.push_back({"asset.lossless", asset(), {.lossless = true}});
  Mesh floats = testing::bumpy_grid(12, 10);  // of no lattice
  for (std::size_t i = 0; i < floats.positions.size(); ++i)
    floats.positions[i] = std::ldexp(floats.positions[i] + 1.1F, -static_cast<int>(i % 31));
  list.push_back({"floats.lossless", floats, {.lossless = true}});
  EncodeOptions walked{.geometry = GeometryCoder::kPredictive, .effort = 9};
  walked.bits = 12;
  list.push_back({"sphere.walked", *generate_scene(Scene::kSphere, 500, 1), walked});
  list.push_back({"grid.lossless", testing::bumpy_grid(12, 10), {.lossless = true}});
  list.push_back({"room.voxels",
                  *generate_scene(Scene::kRooms, 600, 3),
                  {.quality = {.max_error = QualityBound{0.02}}, .geometry = GeometryCoder::kPredictive}});
  for (const auto& named : testing::awkward_meshes()) {
    if (named.name == "seam") list.push_back({"seam.step", named.mesh, {.step = 0.01}});
    if (named.name == "three faces on an edge") list.push_back({"nonmanifold.default", named.mesh, {}});
    if (named.name == "isolated vertices")
      list.push_back({"isolated.all", named.mesh, {.keep_unreferenced = true}});
  }
  return list;
}

std::string path_of(const Golden& golden, const char* suffix) {
  return std::string(DELTAMESH_GOLDEN_DIR "/") + golden.name + ".v1d13." + suffix;
}

/// A line for each attribute: its name, and FNV-1a of its values' bits. Where they are floats they are made
/// by operations that every machine rounds alike.
std::string digests_of(const Mesh& mesh) {
  std::ostringstream text;
  for (const Attribute& attribute : mesh.attributes) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const std::byte byte : attribute.values)
      hash = (hash ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3;
    text << attribute.name << ' ' << std::hex << hash << '\n';
  }
  for (const std::uint32_t group : mesh.face_groups) text << group;
  return text.str();
}

void rewrite(const Golden& golden) {
  const auto encoded = encode(golden.mesh, golden.options);
  ASSERT_TRUE(encoded);
  ASSERT_TRUE(write_file(path_of(golden, "dmsh"), encoded->bytes));
  Mesh decoded = *decode(encoded->bytes);
  const std::string digests = digests_of(decoded);
  if (!digests.empty()) {
    ASSERT_TRUE(write_file(path_of(golden, "digests"), std::as_bytes(std::span(digests))));
  }
  decoded.attributes.clear();
  ASSERT_TRUE(write_mesh_file(path_of(golden, "off"), decoded));
}

TEST(Golden, DecodesToTheCommittedMesh) {
  for (const Golden& golden : golden_streams()) {
    SCOPED_TRACE(golden.name);
    if (update_golden) rewrite(golden);
    const auto bytes = read_file(path_of(golden, "dmsh"));
    ASSERT_TRUE(bytes) << describe(bytes.error());
    const auto decoded = decode(*bytes);
    ASSERT_TRUE(decoded) << describe(decoded.error());
    const auto expected = read_mesh_file(path_of(golden, "off"));
    ASSERT_TRUE(expected) << describe(expected.error());
    EXPECT_EQ(decoded->triangles, expected->mesh.triangles);
    const std::string digests = digests_of(*decoded);
    const auto committed = digests.empty() ? Result<std::vector<std::byte>>(std::vector<std::byte>())
                                           : read_file(path_of(golden, "digests"));
    ASSERT_TRUE(committed) << describe(committed.error());
    EXPECT_EQ(digests, std::string(reinterpret_cast<const char*>(committed->data()), committed->size()));
    ASSERT_EQ(decoded->positions.size(), expected->mesh.positions.size());
    // The solve is exact only up to rounding, and the reference solver's rounding is the machine's.
    const double tolerance = 1e-5 * inspect(*bytes)->diagonal;
    for (std::size_t i = 0; i < decoded->positions.size(); ++i)
      EXPECT_NEAR(decoded->positions[i], expected->mesh.positions[i], tolerance);
  }
}

TEST(Golden, CMP2CMP4CMP8FLD13FLD14FLD15CompactStreamsKeepTheirNumbers) {
  if (update_golden) GTEST_SKIP() << "being rewritten";
  const auto bytes = read_file(DELTAMESH_GOLDEN_DIR "/attributes.compact.v1d13.dmsh");
  ASSERT_TRUE(bytes);
  std::size_t compact = 0;
  const auto info = inspect(*bytes);
  for (const ChunkInfo& chunk : info->chunks) compact += std::string(chunk.codec) == "compact";
  EXPECT_GE(compact, 4U) << "connectivity, deltas and attributes";
  // Colours and the score come back exactly; a formula that drifts would garble them.
  const auto decoded = decode(*bytes);
  ASSERT_TRUE(decoded);
  const Mesh source = rough_grid();
  for (const std::size_t a : {std::size_t{1}, std::size_t{3}}) {
    const std::size_t row = source.attributes[a].components * component_size(source.attributes[a].type);
    const auto rows = [row](const std::vector<std::byte>& values) {
      const std::string text(reinterpret_cast<const char*>(values.data()), values.size());
      std::vector<std::string> list;
      for (std::size_t i = 0; i < text.size(); i += row) list.push_back(text.substr(i, row));
      std::sort(list.begin(), list.end());
      return list;
    };
    EXPECT_EQ(rows(decoded->attributes[a].values), rows(source.attributes[a].values));
  }
}

TEST(Golden, TodaysEncoderStaysWithinTheCommittedSize) {
  for (const Golden& golden : golden_streams()) {
    const auto bytes = read_file(path_of(golden, "dmsh"));
    ASSERT_TRUE(bytes);
    EXPECT_LE(encode(golden.mesh, golden.options)->bytes.size(), bytes->size() + bytes->size() / 50)
        << golden.name;
  }
}

}  // namespace
}  // namespace deltamesh

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  for (int i = 1; i < argc; ++i) deltamesh::update_golden |= std::strcmp(argv[i], "--update_golden") == 0;
  return RUN_ALL_TESTS();
}
