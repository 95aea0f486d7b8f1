// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "predictive/blend.h"

#include <algorithm>
#include <cstdlib>

#include "base/mean.h"

namespace deltamesh {
namespace {

/// a + b - opposite, from `base`.
std::int64_t corner_of(const Parallelogram& p, std::span<const Cell> cells, std::size_t axis,
                       std::int64_t base) noexcept {
  return std::int64_t{cells[p.a][axis]} + cells[p.b][axis] - cells[p.opposite][axis] - base;
}

}  // namespace

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

LocalMeans local_means(const Surroundings& around, std::span<const Cell> cells) noexcept {
  LocalMeans means;
  const Cell& base = cells[around.neighbors[0]];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::int64_t neighbors = 0;
    for (unsigned i = 0; i < around.neighbor_count; ++i)
      neighbors += std::int64_t{cells[around.neighbors[i]][axis]} - base[axis];
    std::int64_t corners = 0;
    std::int64_t edges = 0;
    for (unsigned i = 0; i < around.parallelogram_count; ++i) {
      const Parallelogram& p = around.parallelograms[i];
      const std::int64_t ends =
          std::int64_t{cells[p.a][axis]} + cells[p.b][axis] - 2 * std::int64_t{base[axis]};
      edges += ends;
      corners += ends - (std::int64_t{cells[p.opposite][axis]} - base[axis]);
    }
    means.neighbors[axis] = mean_of(16 * neighbors, around.neighbor_count);
    means.parallelograms[axis] = mean_of(16 * corners, around.parallelogram_count);
    means.edges[axis] = mean_of(8 * edges, around.parallelogram_count);
  }
  return means;
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
  const LocalMeans means = local_means(around, cells);
  if (around.parallelogram_count == 0) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::int64_t apart = 0;
      for (unsigned i = 0; i < around.neighbor_count; ++i)
        apart += std::llabs(16 * (std::int64_t{cells[around.neighbors[i]][axis]} - base[axis]) -
                            means.neighbors[axis]);
      result.place[axis] = 16 * std::int64_t{base[axis]} + means.neighbors[axis];
      result.spread[axis] = mean_of(apart, around.neighbor_count);
    }
    return result;
  }
  const Blend& blend = table[blend_row(around)];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t neighbors = means.neighbors[axis];
    const std::int64_t moved = blend.parallelogram * (means.parallelograms[axis] - neighbors) +
                               blend.edge * (means.edges[axis] - neighbors);
    const std::int64_t local = neighbors + moved / kBlendUnit;
    std::int64_t apart = 0;
    for (unsigned i = 0; i < around.parallelogram_count; ++i)
      apart += std::llabs(16 * corner_of(around.parallelograms[i], cells, axis, base[axis]) -
                          means.parallelograms[axis]);
    result.place[axis] = 16 * std::int64_t{base[axis]} + local;
    result.spread[axis] = mean_of(apart, around.parallelogram_count);
  }
  return result;
}

}  // namespace deltamesh
