// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Errors are those against what positions stand for, and bounds fit the mesh, not its box.
#include <gtest/gtest.h>

#include <cmath>

#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "support/meshes.h"

namespace deltamesh::source_error_test {
namespace {

/// On no lattice.
Mesh rough_grid(std::uint32_t columns, std::uint32_t rows) {
  Mesh mesh = test::bumpy_grid(columns, rows);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    mesh.positions[i] += 0.3F * std::sin(1.7F * static_cast<float>(i));
  return mesh;
}

QualityRequest max_error(double value, QualityUnit unit = QualityUnit::kModel) {
  return {.max_error = QualityBound{.value = value, .unit = unit}};
}

TEST(SourceError, CountsInBoundsAndFigures) {
  const Mesh mesh = rough_grid(40, 30);
  const auto plain = encode(mesh, {.quality = max_error(0.01)});
  const auto counted = encode(mesh, {.quality = max_error(0.01), .source_error = 0.004});
  const auto finer = encode(mesh, {.quality = max_error(0.006)});
  ASSERT_TRUE(plain && counted && finer);
  EXPECT_LE(counted->report.stream.quality.max_error, 0.01);
  EXPECT_NEAR(counted->report.stream.quality.max_error, finer->report.stream.quality.max_error + 0.004, 2e-4);
  EXPECT_GT(counted->bytes.size(), plain->bytes.size());
  const auto lossless = encode(mesh, {.lossless = true, .source_error = 0.004});
  ASSERT_TRUE(lossless);
  EXPECT_NEAR(lossless->report.stream.quality.max_error, 0.004, 1e-6);
  const auto unmet = encode(mesh, {.quality = max_error(0.004), .source_error = 0.004});
  ASSERT_FALSE(unmet);
  EXPECT_EQ(unmet.error().code, ErrorCode::kUnmetRequest);
  EXPECT_FALSE(encode(mesh, {.source_error = -1}));
}

TEST(SourceError, DefaultBoundsGiveWayToIt) {
  const Mesh mesh = rough_grid(40, 30);
  const auto encoded = encode(mesh, {.source_error = 10});
  ASSERT_TRUE(encoded);
  EXPECT_GE(encoded->report.stream.quality.max_error, 10);
}

TEST(Strays, CountNeitherForDefaultsNorForPercents) {
  const Mesh clean = rough_grid(60, 60);
  Mesh mesh = clean;
  const auto last = static_cast<std::uint32_t>(mesh.vertex_count());
  mesh.positions.insert(mesh.positions.end(), {1e6F, 0, 0});
  mesh.triangles.insert(mesh.triangles.end(), {0, 1, last});
  for (const QualityRequest& quality : {QualityRequest{}, max_error(0.05, QualityUnit::kDiagonal)}) {
    const auto without = encode(clean, {.quality = quality});
    const auto with = encode(mesh, {.quality = quality});
    ASSERT_TRUE(without && with);
    const StreamInfo& info = with->report.stream;
    EXPECT_LE(info.quality.max_error, (quality.empty() ? 0.0002 : 0.0005) * info.extent);
    EXPECT_EQ(info.stray_vertices, 1U);
    EXPECT_NEAR(info.extent, without->report.stream.diagonal, 0.1);  // that of the lattice's box
    EXPECT_GT(info.diagonal, 1e5);
    EXPECT_EQ(without->report.stream.stray_vertices, 0U);
    EXPECT_EQ(without->report.stream.extent, without->report.stream.diagonal);
  }
}

}  // namespace
}  // namespace deltamesh::source_error_test
