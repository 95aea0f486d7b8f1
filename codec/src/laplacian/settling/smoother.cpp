// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/smoother.h"

#include "laplacian/settling/edges.h"

namespace deltamesh::settling {
namespace {

/// Weighted sum of the rows at the other ends of edges: of one half of a node's or of all.
template <bool kUnitWeights>
Row sum_rows(const Level& level, std::span<const Row> u, std::uint32_t begin, std::uint32_t end) noexcept {
  Row sum{};
  if constexpr (!kUnitWeights)
    return Edges(level).add_pairs(
        begin, end, [&](std::uint32_t other) { return u[other]; }, sum);
  for (std::uint32_t e = begin; e < end; ++e) sum += u[level.neighbors[e]];
  return sum;
}

/// Solves the equations of a node, given what its neighbours add up to. `x`: kept by nodes without
/// neighbours.
Row relax(const Level& level, std::uint32_t i, const Row& b, const Row& sum, Float4 x) noexcept {
  const float inverse = level.inverse_degree[i];
  if (inverse == 0) return {x, (level.mass[i] > 0 ? 1 / level.mass[i] : 0.0F) * b.x};
  const Float4 s = inverse * (sum.s + b.s);
  return {inverse * (sum.x + b.x - level.mass[i] * s), s};
}

template <bool kUnitWeights>
void smooth_all(const Level& level, std::span<const Row> b, std::span<Row> u) {
  level.chunks.visit([&](std::uint32_t i) {
    u[i] = relax(level, i, b[i], sum_rows<kUnitWeights>(level, u, level.offsets[i], level.offsets[i + 1]),
                 u[i].x);
  });
}

template <bool kUnitWeights>
void restrict_all(const Level& level, std::span<const Row> b, std::span<const Row> u, std::span<Row> coarse) {
  for (std::uint32_t i = 0; i < coarse.size(); ++i) coarse[i] = Row{};
  const auto at = [&](std::uint32_t node) -> Row& { return coarse[node]; };
  level.chunks.visit([&](std::uint32_t i) {
    const Row sum = sum_rows<kUnitWeights>(level, u, level.offsets[i], level.offsets[i + 1]);
    const float degree = level.degree[i];
    const Row residual{b[i].x + sum.x - degree * u[i].x - level.mass[i] * u[i].s,
                       b[i].s + sum.s - degree * u[i].s};
    level.interpolation[i].spread(residual, at);
  });
}

}  // namespace

void smooth(const Level& level, std::span<const Row> b, std::span<Row> u) {
  level.has_unit_weights() ? smooth_all<true>(level, b, u) : smooth_all<false>(level, b, u);
}

void smooth_from_zero(const Level& level, std::span<const Row> b, std::span<Row> u) {
  for (const std::uint32_t i : level.chunks.rim) u[i] = Row{};  // these come last
  const auto relax_from_zero = [&](std::uint32_t i, std::uint32_t end) {
    u[i] = relax(level, i, b[i], sum_rows<false>(level, u, level.offsets[i], end), Float4{});
  };
  level.chunks.visit([&](std::uint32_t i) { relax_from_zero(i, level.middle[i]); },
                     [&](std::uint32_t i) { relax_from_zero(i, level.offsets[i + 1]); });
}

void restrict_residual_from_zero(const Level& level, std::span<const Row> b, std::span<const Row> u,
                                 std::span<Row> coarse) {
  for (std::uint32_t i = 0; i < coarse.size(); ++i) coarse[i] = Row{};
  const auto at = [&](std::uint32_t node) -> Row& { return coarse[node]; };
  const auto inner = [&](std::uint32_t i) {
    Row residual = sum_rows<false>(level, u, level.middle[i], level.offsets[i + 1]);
    if (level.inverse_degree[i] == 0) residual.s = b[i].s;
    level.interpolation[i].spread(residual, at);
  };
  // Those on the rim came after the others, which have heard of higher ones only.
  const auto outer = [&](std::uint32_t i) {
    Row residual{};
    for (std::uint32_t e = level.middle[i]; e < level.offsets[i + 1]; ++e) {
      const std::uint32_t neighbor = level.neighbors[e];
      const float weight = level.weights[e];
      if (level.chunks.is_on_rim[neighbor]) {
        residual += weight * u[neighbor];
      } else {
        level.interpolation[neighbor].spread(weight * u[i], at);
      }
    }
    level.interpolation[i].spread(residual, at);
  };
  level.chunks.visit(inner, outer);
}

void restrict_residual(const Level& level, std::span<const Row> b, std::span<const Row> u,
                       std::span<Row> coarse) {
  level.has_unit_weights() ? restrict_all<true>(level, b, u, coarse)
                           : restrict_all<false>(level, b, u, coarse);
}

}  // namespace deltamesh::settling
