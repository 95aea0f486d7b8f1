// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Every mesh of the corpus through the whole pipeline, one test per file.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "corpus_files.h"
#include "deltamesh/compare.h"
#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "deltamesh/io.h"

namespace deltamesh {
namespace {

using testing_corpus::corpus;
using testing_corpus::mesh_files;
using testing_corpus::test_name;

constexpr std::size_t kSmall = 20'000;  ///< vertices up to which the more expensive checks are made

std::size_t referenced_vertices(const Mesh& mesh) {
  std::vector<bool> used(mesh.vertex_count());
  for (const std::uint32_t v : mesh.triangles) used[v] = true;
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
}

/// Within 1 % of each other, or both next to nothing.
void expect_close(double a, double b, double diagonal, const char* what) {
  EXPECT_LE(std::abs(a - b), 0.01 * std::max(a, b) + 1e-9 * diagonal) << what << ' ' << a << ' ' << b;
}

void expect_achieved(const StreamInfo& told, const Comparison& measured) {
  expect_close(told.diagonal, measured.diagonal, measured.diagonal, "diagonal");
  expect_close(told.quality.vde_rms, measured.quality.vde_rms, measured.diagonal, "VDE");
  expect_close(told.quality.lfe_rms, measured.quality.lfe_rms, measured.diagonal, "LFE");
  expect_close(told.quality.max_error, measured.quality.max_error, measured.diagonal, "max error");
}

void expect_order_kept(const Mesh& mesh) {
  const auto encoded = encode(mesh, {.keep_order = true, .keep_unreferenced = true});
  ASSERT_TRUE(encoded) << describe(encoded.error());
  const auto decoded = decode(encoded->bytes);
  ASSERT_TRUE(decoded) << describe(decoded.error());
  EXPECT_EQ(decoded->triangles, mesh.triangles);
  EXPECT_EQ(decoded->vertex_count(), mesh.vertex_count());
  for (std::uint32_t v = 0; v < encoded->order.size(); ++v) ASSERT_EQ(encoded->order[v], v);
}

class CorpusRoundtrip : public testing::TestWithParam<std::string> {};

TEST_P(CorpusRoundtrip, KeepsTopologyAndTellsTheTruth) {
  if (GetParam().empty()) GTEST_SKIP() << "skipped: no corpus";
  const auto imported = read_mesh_file((corpus() / GetParam()).string());
  ASSERT_TRUE(imported) << describe(imported.error());
  const Mesh& mesh = imported->mesh;

  const EncodeOptions options{.bits = 8};
  const auto encoded = encode(mesh, options);
  ASSERT_TRUE(encoded) << describe(encoded.error());
  const auto told = inspect(encoded->bytes);
  ASSERT_TRUE(told) << describe(told.error());
  EXPECT_TRUE(verify(encoded->bytes));

  const auto decoded = decode(encoded->bytes);
  ASSERT_TRUE(decoded) << describe(decoded.error());
  EXPECT_EQ(decoded->vertex_count(), referenced_vertices(mesh));
  EXPECT_EQ(decoded->triangle_count(), mesh.triangle_count());
  EXPECT_EQ(told->vertices, decoded->vertex_count());
  EXPECT_EQ(told->triangles, decoded->triangle_count());
  EXPECT_EQ(encoded->report.unreferenced_vertices, mesh.vertex_count() - referenced_vertices(mesh));
  EXPECT_EQ(decoded->attributes.size(), mesh.attributes.size());

  const auto compared = compare(mesh, *decoded, encoded->order);
  ASSERT_TRUE(compared) << describe(compared.error());
  ASSERT_TRUE(compared->corresponding);
  expect_achieved(*told, *compared);
  EXPECT_LT(compared->quality.max_error, 0.1 * compared->diagonal);
  if (GetParam() == "robot/helens_dem_grid.ply") {  // UTM coordinates
    EXPECT_LT(compared->quality.max_error, 0.002 * compared->diagonal);
  }

  if (mesh.vertex_count() > kSmall) return;
  EXPECT_EQ(encode(mesh, options)->bytes, encoded->bytes);
  expect_order_kept(mesh);
}

INSTANTIATE_TEST_SUITE_P(Meshes, CorpusRoundtrip, testing::ValuesIn(mesh_files()), test_name);

}  // namespace
}  // namespace deltamesh
