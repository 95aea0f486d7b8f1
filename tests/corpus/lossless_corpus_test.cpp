// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Every mesh of the corpus without loss, in the file's order and in the coder's. A mesh is what reading its
// file gives, which every writer of ours starts from as well: polygons split into triangles, numbers as
// float32.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "corpus_files.h"
#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "deltamesh/io.h"

namespace deltamesh {
namespace {

using testing_corpus::corpus;
using testing_corpus::mesh_files;
using testing_corpus::test_name;

/// Vertex v of `decoded` has the bits of vertex order[v] of `mesh`, attributes included.
void expect_same_vertices(const Mesh& mesh, const Mesh& decoded, std::span<const std::uint32_t> order) {
  ASSERT_EQ(decoded.vertex_count(), order.size());
  ASSERT_EQ(decoded.attributes.size(), mesh.attributes.size());
  const auto same_row = [&](const void* a, const void* b, std::size_t row, std::size_t v) {
    return std::memcmp(static_cast<const std::byte*>(a) + v * row,
                       static_cast<const std::byte*>(b) + order[v] * row, row) == 0;
  };
  for (std::size_t v = 0; v < order.size(); ++v)
    ASSERT_TRUE(same_row(decoded.positions.data(), mesh.positions.data(), 3 * sizeof(float), v)) << v;
  for (std::size_t a = 0; a < mesh.attributes.size(); ++a) {
    const Attribute& before = mesh.attributes[a];
    const Attribute& after = decoded.attributes[a];
    ASSERT_EQ(after.name, before.name);
    ASSERT_EQ(after.type, before.type);
    const std::size_t row = before.components * component_size(before.type);
    for (std::size_t v = 0; v < order.size(); ++v)
      ASSERT_TRUE(same_row(after.values.data(), before.values.data(), row, v)) << before.name << ' ' << v;
  }
}

using Face = std::array<std::uint32_t, 3>;

/// The faces over input vertices, each from its lowest corner on, sorted. `order`: empty for the same
/// vertices.
std::vector<Face> sorted_faces(const Mesh& mesh, std::span<const std::uint32_t> order) {
  std::vector<Face> faces(mesh.triangle_count());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = mesh.triangles[3 * f + k];
      faces[f][k] = order.empty() ? v : order[v];
    }
    std::rotate(faces[f].begin(), std::min_element(faces[f].begin(), faces[f].end()), faces[f].end());
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

class LosslessCorpus : public testing::TestWithParam<std::string> {};

TEST_P(LosslessCorpus, EveryBitComesBack) {
  if (GetParam().empty()) GTEST_SKIP() << "skipped: no corpus";
  const auto imported = read_mesh_file((corpus() / GetParam()).string());
  ASSERT_TRUE(imported) << describe(imported.error());
  const Mesh& mesh = imported->mesh;
  for (const bool keep_order : {false, true}) {
    const auto encoded =
        encode(mesh, {.lossless = true, .keep_order = keep_order, .keep_unreferenced = true});
    ASSERT_TRUE(encoded) << describe(encoded.error());
    EXPECT_EQ(encoded->report.stream.quality.max_error, 0);
    const auto decoded = decode(encoded->bytes);
    ASSERT_TRUE(decoded) << describe(decoded.error());
    EXPECT_EQ(decoded->origin, mesh.origin);
    expect_same_vertices(mesh, *decoded, encoded->order);
    if (keep_order) {
      EXPECT_EQ(decoded->triangles, mesh.triangles);
      EXPECT_TRUE(std::is_sorted(encoded->order.begin(), encoded->order.end()));
    } else {
      EXPECT_EQ(sorted_faces(*decoded, encoded->order), sorted_faces(mesh, {}));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, LosslessCorpus, testing::ValuesIn(mesh_files()), test_name);

}  // namespace
}  // namespace deltamesh
