// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "field/noise.h"

#include <cmath>

namespace deltamesh::scenes {
namespace {

/// The quintic 6t^5 - 15t^4 + 10t^3: first and second derivatives vanish at 0 and 1.
double ease(double t) noexcept { return t * t * t * (t * (6 * t - 15) + 10); }

double mix(double a, double b, double t) noexcept { return a + (b - a) * t; }

}  // namespace

double place_noise(std::int64_t x, std::int64_t y, std::int64_t z, std::uint64_t seed) noexcept {
  const std::uint64_t place = static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15U ^
                              static_cast<std::uint64_t>(y) * 0xc2b2ae3d27d4eb4fU ^
                              static_cast<std::uint64_t>(z) * 0x165667b19e3779f9U;
  return 2 * unit_interval(scatter(place + seed)) - 1;
}

double smooth_noise(const Point& p, std::uint64_t seed) noexcept {
  const double fx = std::floor(p.x);
  const double fy = std::floor(p.y);
  const double fz = std::floor(p.z);
  const auto x = static_cast<std::int64_t>(fx);
  const auto y = static_cast<std::int64_t>(fy);
  const auto z = static_cast<std::int64_t>(fz);
  const double tx = ease(p.x - fx);
  const double ty = ease(p.y - fy);
  const auto row = [&](std::int64_t dy, std::int64_t dz) {
    return mix(place_noise(x, y + dy, z + dz, seed), place_noise(x + 1, y + dy, z + dz, seed), tx);
  };
  return mix(mix(row(0, 0), row(1, 0), ty), mix(row(0, 1), row(1, 1), ty), ease(p.z - fz));
}

double fractal_noise(const Point& p, int octaves, std::uint64_t seed) noexcept {
  double sum = 0;
  double scale = 1;
  for (int i = 0; i < octaves; ++i, scale *= 2)
    sum += smooth_noise(scale * p, scatter(seed + static_cast<std::uint64_t>(i))) / scale;
  return sum;
}

double ridged_noise(const Point& p, int octaves, std::uint64_t seed) noexcept {
  double sum = 0;
  double scale = 1;
  double weight = 1;
  for (int i = 0; i < octaves; ++i, scale *= 2) {
    const double crest =
        1 - std::fabs(smooth_noise(scale * p, scatter(seed + static_cast<std::uint64_t>(i))));
    sum += weight * crest * crest / scale;
    weight = crest * crest * weight;
  }
  return sum;
}

}  // namespace deltamesh::scenes
