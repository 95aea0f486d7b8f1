// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "predictive/blend_fit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace deltamesh {
namespace {

/// A row's 17 bits pay from about this many vertices on.
constexpr std::uint32_t kFewestVertices = 60;

/// Normal equations of one row for its two weights.
struct RowFit {
  double pp = 0;
  double pe = 0;
  double ee = 0;
  double pt = 0;
  double et = 0;
  std::uint32_t vertices = 0;

  void add(double weight, double parallelogram, double edge, double target) noexcept {
    pp += weight * parallelogram * parallelogram;
    pe += weight * parallelogram * edge;
    ee += weight * edge * edge;
    pt += weight * parallelogram * target;
    et += weight * edge * target;
  }

  /// Drawn a little towards `usual`.
  Blend solve(const Blend& usual) const noexcept {
    const double ridge = 1e-3 * (pp + ee) + 1e-9;
    const double a = pp + ridge;
    const double b = ee + ridge;
    const double s = pt + ridge * usual.parallelogram / kBlendUnit;
    const double t = et + ridge * usual.edge / kBlendUnit;
    const double determinant = a * b - pe * pe;
    return {.parallelogram = rounded((s * b - t * pe) / determinant),
            .edge = rounded((t * a - s * pe) / determinant)};
  }

 private:
  static std::int8_t rounded(double weight) noexcept {
    return static_cast<std::int8_t>(std::clamp(std::round(weight * kBlendUnit), -128.0, 127.0));
  }
};

void add_vertex(RowFit& fit, const LocalMeans& means, const Cell& base, const Cell& cell) noexcept {
  std::array<double, 3> parallelogram{};
  std::array<double, 3> edge{};
  std::array<double, 3> target{};
  double length = 256;  // one step, squared
  double error = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto center = static_cast<double>(means.neighbors[axis]);
    parallelogram[axis] = static_cast<double>(means.parallelograms[axis]) - center;
    edge[axis] = static_cast<double>(means.edges[axis]) - center;
    target[axis] = 16 * (static_cast<double>(cell[axis]) - base[axis]) - center;
    length += parallelogram[axis] * parallelogram[axis];
    const double off = target[axis] - parallelogram[axis];
    error += off * off;
  }
  // Bits count, not squares: what is far off anyway weighs less.
  const double weight = 1 / (0.05 * length + error);
  for (std::size_t axis = 0; axis < 3; ++axis) fit.add(weight, parallelogram[axis], edge[axis], target[axis]);
  ++fit.vertices;
}

}  // namespace

BlendTable fit_blends(const FaceStars& stars, std::span<const Cell> cells) {
  std::array<RowFit, kBlends> fits{};
  for (std::uint32_t v = 0; v < cells.size(); ++v) {
    const Surroundings around = look_around(stars, v);
    if (around.parallelogram_count == 0) continue;
    add_vertex(fits[blend_row(around)], local_means(around, cells), cells[around.neighbors[0]], cells[v]);
  }
  BlendTable table = kUsualBlends;
  for (std::size_t row = 0; row < kBlends; ++row) {
    if (fits[row].vertices >= kFewestVertices) table[row] = fits[row].solve(kUsualBlends[row]);
  }
  return table;
}

}  // namespace deltamesh
