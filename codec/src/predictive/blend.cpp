// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "predictive/blend.h"

#include <algorithm>
#include <cstdlib>

#include "base/mean.h"

namespace deltamesh {

constinit const BlendTable kUsualBlends = [] {
  constexpr std::array<std::int8_t, 5> kParallelogram = {45, 55, 50, 45, 38};
  BlendTable table{};
  for (std::size_t row = 0; row < kBlends; ++row) table[row].parallelogram = kParallelogram[row / 6];
  return table;
}();

std::size_t blend_row(const Surroundings& around) noexcept {
  const std::size_t count = std::min(around.parallelogram_count, 5U) - 1;
  return count * 6 + std::clamp(around.faces, 3U, 8U) - 3;
}

namespace {

using Sums = std::array<std::int64_t, 3>;

/// Of the vertices known around one, all from the first neighbour.
struct LocalSums {
  Sums neighbors{};
  Sums ends{};                                                  ///< a + b of all parallelograms
  std::array<Sums, Surroundings::kMostParallelograms> corners;  ///< a + b - o of each
};

LocalSums local_sums(const Surroundings& around, std::span<const Cell> cells) noexcept {
  LocalSums sums;
  const Cell base = cells[around.neighbors[0]];
  for (unsigned i = 1; i < around.neighbor_count; ++i) {
    const Cell& neighbor = cells[around.neighbors[i]];
    for (std::size_t axis = 0; axis < 3; ++axis) sums.neighbors[axis] += neighbor[axis] - base[axis];
  }
  for (unsigned i = 0; i < around.parallelogram_count; ++i) {
    const Parallelogram& p = around.parallelograms[i];
    const Cell& a = cells[p.a];
    const Cell& b = cells[p.b];
    const Cell& opposite = cells[p.opposite];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::int32_t ends = (a[axis] - base[axis]) + (b[axis] - base[axis]);
      sums.ends[axis] += ends;
      sums.corners[i][axis] = ends - (opposite[axis] - base[axis]);
    }
  }
  return sums;
}

LocalMeans means_of(const LocalSums& sums, const Surroundings& around) noexcept {
  const std::int64_t one_over_neighbors = kOneOver[around.neighbor_count];
  const std::int64_t one_over_parallelograms = kOneOver[around.parallelogram_count];
  LocalMeans means;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::int64_t corners = 0;
    for (unsigned i = 0; i < around.parallelogram_count; ++i) corners += sums.corners[i][axis];
    means.neighbors[axis] = (16 * sums.neighbors[axis] * one_over_neighbors) >> 16;
    means.parallelograms[axis] = (16 * corners * one_over_parallelograms) >> 16;
    means.edges[axis] = (8 * sums.ends[axis] * one_over_parallelograms) >> 16;
  }
  return means;
}

/// Mean distance of the neighbours from their mean.
std::int64_t neighbor_spread(const Surroundings& around, std::span<const Cell> cells, std::size_t axis,
                             std::int64_t mean) noexcept {
  const std::int32_t base = cells[around.neighbors[0]][axis];
  std::int64_t apart = 0;
  for (unsigned i = 0; i < around.neighbor_count; ++i)
    apart += std::llabs(16 * (std::int64_t{cells[around.neighbors[i]][axis]} - base) - mean);
  return mean_of(apart, around.neighbor_count);
}

}  // namespace

LocalMeans local_means(const Surroundings& around, std::span<const Cell> cells) noexcept {
  return means_of(local_sums(around, cells), around);
}

Expectation expect_place(const Surroundings& around, std::uint32_t vertex, std::span<const Cell> cells,
                         const BlendTable& table) noexcept {
  Expectation result;
  if (around.neighbor_count == 0) {
    for (std::size_t axis = 0; axis < 3 && vertex > 0; ++axis)
      result.place[axis] = 16 * std::int64_t{cells[vertex - 1][axis]};
    return result;
  }
  const Cell& base = cells[around.neighbors[0]];
  const LocalSums sums = local_sums(around, cells);
  const LocalMeans means = means_of(sums, around);
  if (around.parallelogram_count == 0) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result.place[axis] = 16 * std::int64_t{base[axis]} + means.neighbors[axis];
      result.spread[axis] = neighbor_spread(around, cells, axis, means.neighbors[axis]);
    }
    return result;
  }
  const Blend& blend = table[blend_row(around)];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t neighbors = means.neighbors[axis];
    const std::int64_t moved = blend.parallelogram * (means.parallelograms[axis] - neighbors) +
                               blend.edge * (means.edges[axis] - neighbors);
    std::int64_t apart = 0;
    for (unsigned i = 0; i < around.parallelogram_count; ++i)
      apart += std::llabs(16 * sums.corners[i][axis] - means.parallelograms[axis]);
    result.place[axis] = 16 * std::int64_t{base[axis]} + neighbors + moved / kBlendUnit;
    result.spread[axis] = mean_of(apart, around.parallelogram_count);
  }
  return result;
}

}  // namespace deltamesh
