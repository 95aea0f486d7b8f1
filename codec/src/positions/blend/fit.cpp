// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "positions/blend/fit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/numbers/portable_math.h"

namespace deltamesh {
namespace {

/// A row's 17 bits pay from about this many vertices on.
constexpr std::size_t kFewestVertices = 60;

/// More say nothing new, or not much.
constexpr std::size_t kMostSamples = 1U << 19;
/// Of a quick fit: one vertex in three, within these bounds.
constexpr std::size_t kFewestSamples = 1U << 12;
constexpr std::size_t kQuickSamples = 1U << 13;

/// One step, squared, in the units of LocalMeans.
constexpr double kStepSquared = 256;

/// What a row's weights are of at one vertex: its sources and its place from the neighbours' mean, 1/16
/// steps.
struct Sample {
  std::array<float, 3> parallelogram;
  std::array<float, 3> edge;
  std::array<float, 3> target;

  double off(const Blend& blend, std::size_t axis) const noexcept {
    return target[axis] -
           (double{parallelogram[axis]} * blend.parallelogram + double{edge[axis]} * blend.edge) / kBlendUnit;
  }
};

Sample sample_of(const LocalMeans& means, const Cell& base, const Cell& cell) noexcept {
  Sample sample{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t center = means.neighbors[axis];
    sample.parallelogram[axis] = static_cast<float>(means.parallelograms[axis] - center);
    sample.edge[axis] = static_cast<float>(means.edges[axis] - center);
    sample.target[axis] = static_cast<float>(16 * (std::int64_t{cell[axis]} - base[axis]) - center);
  }
  return sample;
}

/// Normal equations of one row for its two weights.
struct RowFit {
  double pp = 0;
  double pe = 0;
  double ee = 0;
  double pt = 0;
  double et = 0;

  void add(double weight, const Sample& sample, std::size_t axis) noexcept {
    const double parallelogram = sample.parallelogram[axis];
    const double edge = sample.edge[axis];
    const double target = sample.target[axis];
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

void add_squares(RowFit& fit, const Sample& sample) noexcept {
  double length = kStepSquared;
  double error = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    length += double{sample.parallelogram[axis]} * sample.parallelogram[axis];
    const double off = double{sample.target[axis]} - sample.parallelogram[axis];
    error += off * off;
  }
  // Bits count, not squares: what is far off anyway weighs less.
  const double weight = 1 / (0.05 * length + error);
  for (std::size_t axis = 0; axis < 3; ++axis) fit.add(weight, sample, axis);
}

/// About the bits of the residuals.
double bits_of(std::span<const Sample> samples, const Blend& blend) noexcept {
  double bits = 0;
  for (const Sample& sample : samples) {
    double product = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double off = sample.off(blend, axis);
      product *= kStepSquared / 4 + off * off;
    }
    bits += portable_log2(product) / 2;
  }
  return bits;
}

/// Least squares again and again, each residual weighted by its size in the last: a minimum of bits_of()
/// near `blend`.
Blend fit_bits(std::span<const Sample> samples, Blend blend) noexcept {
  constexpr int kRounds = 4;
  const Blend usual = blend;
  for (int i = 0; i < kRounds; ++i) {
    RowFit fit;
    for (const Sample& sample : samples) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double off = sample.off(blend, axis);
        fit.add(1 / (kStepSquared + off * off), sample, axis);
      }
    }
    blend = fit.solve(usual);
  }
  return blend;
}

/// The better of the minima near `squares`, which least squares gave, and near the plain parallelogram.
Blend fit_row(std::span<const Sample> samples, const Blend& squares) noexcept {
  Blend best = squares;
  double least = bits_of(samples, best);
  for (const Blend& start : {squares, Blend{}}) {
    const Blend blend = fit_bits(samples, start);
    const double bits = bits_of(samples, blend);
    if (bits >= least) continue;
    least = bits;
    best = blend;
  }
  return best;
}

/// What a table is fitted to.
struct RowSamples {
  RowFit squares;
  std::size_t count = 0;
  std::vector<Sample> samples;  ///< of kBits
};

}  // namespace

BlendTable fit_blends(const KnownFaces& faces, std::span<const Cell> cells, BlendFit fit) {
  std::array<RowSamples, kBlends> rows;
  const std::size_t most =
      fit == BlendFit::kSample ? std::clamp(cells.size() / 3, kFewestSamples, kQuickSamples) : kMostSamples;
  const std::size_t stride = 1 + cells.size() / most;
  for (std::size_t v = 0; v < cells.size(); v += stride) {
    const Surroundings around = faces.around(static_cast<std::uint32_t>(v));
    if (around.parallelogram_count == 0) continue;
    RowSamples& row = rows[blend_row(around)];
    const Sample sample = sample_of(local_means(around, cells), cells[around.known[0].a], cells[v]);
    add_squares(row.squares, sample);
    ++row.count;
    if (fit == BlendFit::kBits) row.samples.push_back(sample);
  }
  BlendTable table = kUsualBlends;
  for (std::size_t row = 0; row < kBlends; ++row) {
    if (rows[row].count < kFewestVertices) continue;
    table[row] = rows[row].squares.solve(kUsualBlends[row]);
    if (fit == BlendFit::kBits) table[row] = fit_row(rows[row].samples, table[row]);
  }
  return table;
}

}  // namespace deltamesh
