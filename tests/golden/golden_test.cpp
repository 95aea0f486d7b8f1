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
  const char* name;  ///< tests/golden/<name>.v1d12.dmsh and .off
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
                  {.quality = {.max_error = 0.02}, .geometry = GeometryCoder::kPredictive}});
  for (const auto& named : testing::awkward_meshes()) {
    if (named.name == "seam") list.push_back({"seam.step", named.mesh, {.step = 0.01}});
    if (named.name == "three faces on an edge") list.push_back({"nonmanifold.default", named.mesh, {}});
    if (named.name == "isolated vertices")
      list.push_back({"isolated.all", named.mesh, {.keep_unreferenced = true}});
  }
  return list;
}

std::string path_of(const Golden& golden, const char* suffix) {
  return std::string(DELTAMESH_GOLDEN_DIR "/") + golden.name + ".v1d12." + suffix;
}

void rewrite(const Golden& golden) {
  const auto encoded = encode(golden.mesh, golden.options);
  ASSERT_TRUE(encoded);
  ASSERT_TRUE(write_file(path_of(golden, "dmsh"), encoded->bytes));
  Mesh decoded = *decode(encoded->bytes);
  decoded.attributes.clear();
  ASSERT_TRUE(write_mesh_file(path_of(golden, "off"), decoded));
}

/// Attributes are coded apart from the positions, in integers: they come out the same to the last bit.
void expect_same_attributes(const Mesh& committed, const Mesh& today) {
  ASSERT_EQ(committed.attributes.size(), today.attributes.size());
  for (std::size_t i = 0; i < today.attributes.size(); ++i) {
    EXPECT_EQ(committed.attributes[i].name, today.attributes[i].name);
    EXPECT_EQ(committed.attributes[i].kind, today.attributes[i].kind);
    EXPECT_EQ(committed.attributes[i].values, today.attributes[i].values) << today.attributes[i].name;
  }
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
    expect_same_attributes(*decoded, *decode(encode(golden.mesh, golden.options)->bytes));
    ASSERT_EQ(decoded->positions.size(), expected->mesh.positions.size());
    // The solve is exact only up to rounding, and the reference solver's rounding is the machine's.
    const double tolerance = 1e-5 * inspect(*bytes)->diagonal;
    for (std::size_t i = 0; i < decoded->positions.size(); ++i)
      EXPECT_NEAR(decoded->positions[i], expected->mesh.positions[i], tolerance);
  }
}

TEST(Golden, CMP2CMP4CMP8FLD2FLD3FLD4FLD5FLD6CompactStreamsKeepTheirNumbers) {
  if (update_golden) GTEST_SKIP() << "being rewritten";
  const auto bytes = read_file(DELTAMESH_GOLDEN_DIR "/attributes.compact.v1d12.dmsh");
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
