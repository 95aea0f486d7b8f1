// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "encoder/coder_forecast.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace deltamesh {
namespace {

constexpr std::size_t kSample = 16384;
constexpr double kDeltaStep = 1 / 0.38;   ///< of deltas, in terms of the VDE they cause
constexpr double kLatticeStep = 1.85;     ///< of positions, likewise
constexpr double kParallelograms = 0.75;  ///< against the neighbours' mean

double bits_of(const Vec3& off, double step) noexcept {
  double product = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) product *= 1 + 2 * std::abs(off[axis]) / step;
  return std::log2(product);
}

template <class Vertices>
Vec3 mean_of_positions(const Vertices& vertices, std::span<const Vec3> positions) noexcept {
  Vec3 sum{};
  for (const std::uint32_t v : vertices) sum = sum + positions[v];
  return (1.0 / static_cast<double>(vertices.size())) * sum;
}

/// Where the vertices before `v` point.
Vec3 expect(const FaceStars& stars, std::uint32_t v, std::span<const Vec3> positions) noexcept {
  const Surroundings around = look_around(stars, v);
  if (around.neighbor_count == 0) return positions[v > 0 ? v - 1 : 0];
  const Vec3 neighbors =
      mean_of_positions(std::span(around.neighbors.data(), around.neighbor_count), positions);
  if (around.parallelogram_count == 0) return neighbors;
  Vec3 corners{};
  for (unsigned i = 0; i < around.parallelogram_count; ++i) {
    const Parallelogram& p = around.parallelograms[i];
    corners = corners + positions[p.a] + positions[p.b] - positions[p.opposite];
  }
  return (kParallelograms / around.parallelogram_count) * corners + (1 - kParallelograms) * neighbors;
}

}  // namespace

bool CoderForecast::predictive_wins() const noexcept {
  return predictive < highpass + std::min(0.345 * highpass, 3.15);
}

CoderForecast forecast_coders(const Adjacency& graph, const FaceStars& stars, std::span<const Vec3> positions,
                              double vde) {
  CoderForecast forecast;
  double count = 0;
  const std::size_t stride = 1 + positions.size() / kSample;
  for (std::size_t i = 0; i < positions.size(); i += stride) {
    const auto v = static_cast<std::uint32_t>(i);
    if (graph.degree(v) == 0) continue;
    forecast.highpass += bits_of(positions[v] - mean_of_positions(graph.of(v), positions), kDeltaStep * vde);
    forecast.predictive += bits_of(positions[v] - expect(stars, v, positions), kLatticeStep * vde);
    count += 1;
  }
  forecast.highpass /= std::max(count, 1.0);
  forecast.predictive /= std::max(count, 1.0);
  return forecast;
}

}  // namespace deltamesh
