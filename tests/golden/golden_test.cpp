// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Committed streams decode to committed vertices and faces, whatever this build's encoder writes.
// `golden_test --update_golden` rewrites them: only on purpose, with a new draft number.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "deltamesh/io.h"
#include "deltamesh/version.h"
#include "golden_streams.h"

namespace deltamesh {
namespace {

using test::Golden;
using test::golden_streams;
using test::rough_grid;

bool update_golden = false;

/// File names carry the number of the draft: a new draft needs new streams.
std::string path_of(const std::string& name, const std::string& suffix) {
  return DELTAMESH_GOLDEN_DIR "/" + name + ".v1d" + std::to_string(kFormatDraft) + '.' + suffix;
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
  ASSERT_TRUE(write_file(path_of(golden.name, "dmsh"), encoded->bytes));
  Mesh decoded = *decode(encoded->bytes);
  const std::string digests = digests_of(decoded);
  if (!digests.empty()) {
    ASSERT_TRUE(write_file(path_of(golden.name, "digests"), std::as_bytes(std::span(digests))));
  }
  decoded.attributes.clear();
  decoded.origin = {};
  ASSERT_TRUE(write_mesh_file(path_of(golden.name, "off"), decoded));
}

TEST(Golden, DecodesToTheCommittedMesh) {
  for (const Golden& golden : golden_streams()) {
    SCOPED_TRACE(golden.name);
    if (update_golden) rewrite(golden);
    const auto bytes = read_file(path_of(golden.name, "dmsh"));
    ASSERT_TRUE(bytes) << describe(bytes.error());
    const auto decoded = decode(*bytes);
    ASSERT_TRUE(decoded) << describe(decoded.error());
    const auto expected = read_mesh_file(path_of(golden.name, "off"));
    ASSERT_TRUE(expected) << describe(expected.error());
    EXPECT_EQ(decoded->triangles, expected->mesh.triangles);
    const std::string digests = digests_of(*decoded);
    const auto committed = digests.empty() ? Result<std::vector<std::byte>>(std::vector<std::byte>())
                                           : read_file(path_of(golden.name, "digests"));
    ASSERT_TRUE(committed) << describe(committed.error());
    EXPECT_EQ(digests, std::string(reinterpret_cast<const char*>(committed->data()), committed->size()));
    ASSERT_EQ(decoded->positions.size(), expected->mesh.positions.size());
    for (std::size_t i = 0; i < decoded->positions.size(); ++i)
      EXPECT_EQ(decoded->positions[i], expected->mesh.positions[i]) << "coordinate " << i;
  }
}

TEST(Golden, CMP2CMP4CMP8FLD13FLD14FLD15CompactStreamsKeepTheirNumbers) {
  if (update_golden) GTEST_SKIP() << "being rewritten";
  const auto bytes = read_file(path_of("attributes.compact", "dmsh"));
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
    const auto bytes = read_file(path_of(golden.name, "dmsh"));
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
