// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/coder_forecast.h"

#include <gtest/gtest.h>

#include "deltamesh/encode.h"
#include "scenes.h"
#include "support/graph_mesh.h"
#include "support/meshes.h"

namespace deltamesh {
namespace {

CoderForecast forecast_of(const test::GraphMesh& mesh, double vde) {
  const FaceList faces{mesh.triangles, static_cast<std::uint32_t>(mesh.positions.size())};
  return forecast_coders(mesh.graph, faces, mesh.positions, vde);
}

std::string coder_at(const Mesh& mesh, int effort, const QualityRequest& quality) {
  const auto encoded = encode(mesh, {.quality = quality, .effort = effort});
  return encoded ? encoded->report.stream.geometry : describe(encoded.error());
}

TEST(CoderForecast, GrowsAsTheBoundShrinks) {
  const test::GraphMesh mesh = test::sheet(30, 30);
  const CoderForecast coarse = forecast_of(mesh, 0.1);
  const CoderForecast fine = forecast_of(mesh, 0.001);
  EXPECT_GT(coarse.highpass, 0);
  EXPECT_GT(coarse.predictive, 0);
  EXPECT_GT(fine.highpass, coarse.highpass + 6);
  EXPECT_GT(fine.predictive, coarse.predictive + 6);
}

TEST(CoderForecast, MeshesWithoutNeighboursAreFine) {
  EXPECT_EQ(forecast_of(test::finish({}), 0.1).highpass, 0);
  test::GraphMesh lone;
  lone.positions = {{0, 0, 0}, {1, 1, 1}};
  EXPECT_EQ(forecast_of(test::finish(lone), 0.1).predictive, 0);
}

TEST(CoderForecast, PlanesAreForParallelograms) {
  test::GraphMesh mesh;
  for (std::uint32_t y = 0; y < 30; ++y)
    for (std::uint32_t x = 0; x < 30; ++x)
      mesh.positions.push_back({static_cast<double>(x * x), static_cast<double>(y * y), 0});
  for (std::uint32_t y = 0; y + 1 < 30; ++y) {
    for (std::uint32_t x = 0; x + 1 < 30; ++x) {
      const std::uint32_t a = 30 * y + x;
      mesh.triangles.insert(mesh.triangles.end(), {a, a + 1, a + 30, a + 1, a + 31, a + 30});
    }
  }
  EXPECT_TRUE(forecast_of(test::finish(mesh), 0.01).predictive_wins());
}

TEST(CoderForecast, EffortZeroTakesVoxelsForMaps) {
  const Mesh map = *generate_scene(Scene::kRooms, 6000, 3);
  const QualityRequest request{.vde = QualityBound{.value = 0.02, .unit = QualityUnit::kDiagonal}};
  EXPECT_EQ(coder_at(map, 0, request), "grid");
  EXPECT_EQ(coder_at(map, 1, request), "grid");
}

TEST(CoderForecast, EffortZeroTakesDeltasForSmoothScans) {
  const Mesh scan = *generate_scene(Scene::kSphere, 6000, 3);
  const QualityRequest request{.vde = QualityBound{.value = 0.05, .unit = QualityUnit::kDiagonal}};
  EXPECT_EQ(coder_at(scan, 0, request), "highpass");
  EXPECT_EQ(coder_at(scan, 1, request), "highpass");
}

}  // namespace
}  // namespace deltamesh
