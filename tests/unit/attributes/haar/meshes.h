// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Meshes with colours for the tests of the transform.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "attributes/surface.h"
#include "deltamesh/mesh.h"
#include "scenes.h"
#include "support/graph_mesh.h"
#include "support/random.h"

namespace deltamesh::haar_test {

/// Arrays that a surface needs.
struct Colored {
  std::vector<std::uint32_t> triangles;
  std::vector<float> positions;
  std::vector<std::uint8_t> colors;  ///< n x 3
  std::uint32_t count = 0;
  std::vector<std::uint32_t> geometric{};

  AttributeSurface surface() const { return {triangles, count, geometric, positions}; }
};

/// Vertices alone.
inline Colored points(std::vector<float> positions) {
  const auto count = static_cast<std::uint32_t>(positions.size() / 3);
  return {.triangles = {}, .positions = std::move(positions), .colors = {}, .count = count};
}

/// Waves with grain; equal components where `grey`.
inline std::vector<std::uint8_t> waves(std::uint32_t count, bool grey = false) {
  test::RandomBits random(5);
  std::vector<std::uint8_t> colors;
  for (std::uint32_t i = 0; i < count; ++i) {
    for (unsigned c = 0; c < 3; ++c) {
      const double wave = 128 + 100 * std::sin(0.11 * i + (grey ? 0 : c)) + (random() % 16);
      colors.push_back(grey && c > 0 ? colors.back() : static_cast<std::uint8_t>(std::min(wave, 255.0)));
    }
  }
  return colors;
}

inline Colored colored(const test::GraphMesh& mesh, bool grey = false) {
  Colored result{.triangles = mesh.triangles,
                 .positions = {},
                 .colors = {},
                 .count = static_cast<std::uint32_t>(mesh.positions.size())};
  for (const Vec3& p : mesh.positions)
    for (std::size_t axis = 0; axis < 3; ++axis) result.positions.push_back(static_cast<float>(p[axis]));
  result.colors = waves(result.count, grey);
  return result;
}

/// Rooms with the colours of the scene.
inline Colored rooms(std::uint64_t vertices, std::uint64_t seed) {
  const Mesh mesh = *generate_scene(Scene::kRooms, vertices, seed);
  Colored result{.triangles = mesh.triangles,
                 .positions = mesh.positions,
                 .colors = {},
                 .count = static_cast<std::uint32_t>(mesh.positions.size() / 3)};
  const Attribute& colors = mesh.attributes.at(0);
  for (std::size_t v = 0; v < result.count; ++v)
    for (std::size_t c = 0; c < 3; ++c)
      result.colors.push_back(std::to_integer<std::uint8_t>(colors.values[v * colors.components + c]));
  return result;
}

}  // namespace deltamesh::haar_test
