// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>

#include "field/noise.h"
#include "generators.h"

namespace deltamesh::scenes {

Mesh make_torus(std::uint64_t target, std::uint64_t seed) {
  Random random(seed);
  const std::uint64_t shape_seed = random.bits();
  const auto size = static_cast<double>(target);
  const auto across = std::max(3U, static_cast<std::uint32_t>(std::floor(std::sqrt(size / 2.5) + 0.5)));
  const auto around = std::max(3U, static_cast<std::uint32_t>(std::floor(size / across + 0.5)));
  Mesh mesh;
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      const CirclePoint ring = circle((i + random.between(-0.2, 0.2)) / around);
      const CirclePoint tube = circle((j + random.between(-0.2, 0.2)) / across);
      const Point axis{ring.cos, ring.sin, 0};
      const Point outward = tube.cos * axis + Point{0, 0, tube.sin};
      const double bump = 0.06 * fractal_noise(3 * (axis + 0.4 * outward), 4, shape_seed);
      add_vertex(mesh, axis + (0.4 + bump) * outward);
    }
  }
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return i % around * across + j % across; };
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      if (random.chance(0.5)) {
        add_quad(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      } else {
        add_quad(mesh, at(i, j + 1), at(i, j), at(i + 1, j), at(i + 1, j + 1));
      }
    }
  }
  return mesh;
}

}  // namespace deltamesh::scenes
