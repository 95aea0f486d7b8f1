// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/coder_forecast.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/numbers/portable_math.h"

namespace deltamesh {
namespace {

constexpr std::size_t kSample = 16384;
constexpr double kDeltaStep = 1 / 0.38;   ///< of deltas, in terms of the VDE they cause
constexpr double kLatticeStep = 1.85;     ///< of positions, likewise
constexpr double kParallelograms = 0.75;  ///< against the mean of their edges

double bits_of(const Vec3& off, double step) noexcept {
  double product = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) product *= 1 + 2 * std::abs(off[axis]) / step;
  return portable_log2(product);
}

template <class Vertices>
Vec3 mean_of_positions(const Vertices& vertices, std::span<const Vec3> positions) noexcept {
  Vec3 sum{};
  for (const std::uint32_t v : vertices) sum = sum + positions[v];
  return (1.0 / static_cast<double>(vertices.size())) * sum;
}

/// Where the vertices before `v` point.
Vec3 expect(const KnownFaces& faces, std::uint32_t v, std::span<const Vec3> positions) noexcept {
  const Surroundings around = faces.around(v);
  if (around.known_count == 0) return positions[v > 0 ? v - 1 : 0];
  Vec3 ends{};
  Vec3 corners{};
  for (unsigned i = 0; i < around.known_count; ++i) {
    const auto& [a, b, opposite] = around.known[i];
    ends = ends + positions[a] + positions[b];
    if (opposite != kNoVertex) corners = corners + positions[a] + positions[b] - positions[opposite];
  }
  const Vec3 mean = (0.5 / around.known_count) * ends;
  if (around.parallelogram_count == 0) return mean;
  return (kParallelograms / around.parallelogram_count) * corners + (1 - kParallelograms) * mean;
}

}  // namespace

bool CoderForecast::predictive_wins() const noexcept {
  return predictive < highpass + std::min(0.28 * highpass, 3.4);
}

CoderForecast forecast_coders(const Adjacency& graph, const FaceList& list, std::span<const Vec3> positions,
                              double vde) {
  const KnownFaces faces(list);
  CoderForecast forecast;
  double count = 0;
  const std::size_t stride = 1 + positions.size() / kSample;
  for (std::size_t i = 0; i < positions.size(); i += stride) {
    const auto v = static_cast<std::uint32_t>(i);
    if (graph.degree(v) == 0) continue;
    forecast.highpass += bits_of(positions[v] - mean_of_positions(graph.of(v), positions), kDeltaStep * vde);
    forecast.predictive += bits_of(positions[v] - expect(faces, v, positions), kLatticeStep * vde);
    count += 1;
  }
  forecast.highpass /= std::max(count, 1.0);
  forecast.predictive /= std::max(count, 1.0);
  return forecast;
}

}  // namespace deltamesh
