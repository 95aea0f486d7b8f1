// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>

#include "field/noise.h"
#include "generators.h"

namespace deltamesh::scenes {
namespace {

constexpr double kSpacing = 2;  ///< metres between grid points

/// Metres; `p` in metres.
double height(const Point& p, std::uint64_t seed) {
  const Point warp{smooth_noise(0.009 * p, seed + 1), smooth_noise(0.009 * p, seed + 2), 0};
  const Point bent = 0.005 * p + 0.3 * warp;
  return 110 * ridged_noise(bent, 7, seed) + 60 * fractal_noise(0.3 * bent, 3, seed + 3) +
         0.15 * smooth_noise(0.3 * p, seed + 4);
}

}  // namespace

Mesh make_terrain(std::uint64_t target, std::uint64_t seed) {
  Random random(seed);
  const std::uint64_t shape_seed = random.bits();
  const auto size = static_cast<double>(target);
  const auto rows = std::max(2U, static_cast<std::uint32_t>(std::floor(std::sqrt(0.75 * size) + 0.5)));
  const auto columns = std::max(2U, static_cast<std::uint32_t>(std::floor(size / rows + 0.5)));
  Mesh mesh;
  // Easting and northing as a UTM zone has them, and a datum.
  mesh.origin = {500000 + 100.0 * random.below(2000), 5000000 + 100.0 * random.below(5000), 800};
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      Point p{kSpacing * column, kSpacing * row, 0};
      p.z = height(p, shape_seed);
      add_vertex(mesh, p);
    }
  }
  for (std::uint32_t row = 0; row + 1 < rows; ++row) {
    for (std::uint32_t column = 0; column + 1 < columns; ++column) {
      const std::uint32_t corner = row * columns + column;
      add_quad(mesh, corner, corner + 1, corner + columns + 1, corner + columns);
    }
  }
  return mesh;
}

}  // namespace deltamesh::scenes
