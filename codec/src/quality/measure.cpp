// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "quality/measure.h"

#include <algorithm>
#include <cmath>

namespace deltamesh {
namespace {

/// Edges count as at least this share of the diagonal, so that zero-length edges do not divide by zero.
constexpr double kShortestEdge = 1e-9;

double diagonal_of(std::span<const Vec3> positions) noexcept {
  if (positions.empty()) return 0;
  Box box{positions.front(), positions.front()};
  for (const Vec3& position : positions) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = std::min(box.min[axis], position[axis]);
      box.max[axis] = std::max(box.max[axis], position[axis]);
    }
  }
  return box.diagonal();
}

}  // namespace

std::vector<Vec3> geometric_laplacian(const Adjacency& graph, std::span<const Vec3> positions,
                                      double shortest) {
  std::vector<Vec3> result(positions.size());
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    if (graph.degree(v) == 0) continue;
    Vec3 sum{};
    double weights = 0;
    for (const std::uint32_t neighbor : graph.of(v)) {
      // With v itself as origin the weighted sum does not lose digits to far-away coordinates.
      const Vec3 edge = positions[neighbor] - positions[v];
      const double edge_length = std::max(length(edge), shortest);
      const double weight = edge_length > 0 ? 1.0 / edge_length : 1.0;
      sum = sum + weight * edge;
      weights += weight;
    }
    result[v] = (-1.0 / weights) * sum;
  }
  return result;
}

Quality measure_quality(const Adjacency& graph, std::span<const Vec3> original,
                        std::span<const Vec3> decoded) {
  const double shortest = kShortestEdge * diagonal_of(original);
  const std::vector<Vec3> original_laplacian = geometric_laplacian(graph, original, shortest);
  const std::vector<Vec3> decoded_laplacian = geometric_laplacian(graph, decoded, shortest);
  double visual = 0;      // S_q squared
  double positional = 0;  // M_q squared
  double largest = 0;
  std::size_t measured = 0;
  for (std::uint32_t v = 0; v < original.size(); ++v) {
    const Vec3 error = original[v] - decoded[v];
    largest = std::max(largest, dot(error, error));
    if (graph.degree(v) == 0) continue;
    const Vec3 laplacian_error = original_laplacian[v] - decoded_laplacian[v];
    visual += dot(laplacian_error, laplacian_error);
    positional += dot(error, error);
    ++measured;
  }
  const double count = static_cast<double>(std::max<std::size_t>(measured, 1));
  return {.vde_rms = std::sqrt(visual / count),
          .lfe_rms = std::sqrt(positional / count),
          .max_error = std::sqrt(largest)};
}

PaperQuality paper_form(const Quality& quality, std::uint64_t geometric_vertices, double diagonal) noexcept {
  if (!(diagonal > 0)) return {};
  const double scale = std::sqrt(static_cast<double>(geometric_vertices)) / diagonal;
  return {.vde = quality.vde_rms * scale, .lfe = quality.lfe_rms * scale};
}

}  // namespace deltamesh
