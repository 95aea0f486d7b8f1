// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/predictive_search.h"

#include <algorithm>
#include <cmath>

#include "base/numbers/portable_math.h"
#include "base/numbers/short_float.h"
#include "positions/lattice/lattice.h"
#include "search/cell_quality.h"
#include "search/coder_forecast.h"
#include "search/unmet.h"

namespace deltamesh {
namespace {

constexpr int kMostTrials = 10;
constexpr double kCloseEnough = 0.997;  ///< share of a bound that needs no better trial

/// Whether an axis has a grid, and grid_lattice() at `step` or a little above would take it.
bool has_grid(const std::array<AxisGrid, 3>& axes, double step) noexcept {
  return std::any_of(axes.begin(), axes.end(), [step](const AxisGrid& axis) { return axis.step > step / 2; });
}

/// A step near which the bounds are just kept.
double first_step(const Bounds& bounds, const Box& box) noexcept {
  double step = std::max(box.longest_side(), 1e-30);
  // Half a step per axis is the most; a uniform error of one step has a variance of 1/12, and a vertex's
  // neighbours add a little to what is seen at it.
  if (bounds.max_error) step = std::min(step, 2 / std::sqrt(3.0) * *bounds.max_error);
  if (bounds.lfe) step = std::min(step, 2 * *bounds.lfe);
  if (bounds.vde) step = std::min(step, 1.85 * *bounds.vde);
  return step > 0 ? step : 1.0;  // a bound in percent of nothing
}

/// On a cubic lattice but for `axes` with steps of their own; empty where none keeps the bounds.
std::optional<LatticeTrial> keep_on_lattice(const Bounds& bounds, const std::array<AxisGrid, 3>& axes,
                                            const PredictiveTrials& trials) {
  std::optional<LatticeTrial> best;
  double best_step = 0;
  double step = first_step(bounds, trials.source().box);
  std::array<double, 3> last_steps{};
  for (int i = 0; i < kMostTrials; ++i) {
    const PositionLattice lattice = grid_lattice(trials.source().box, axes, short_float_below(step));
    if (lattice.step == last_steps) break;
    last_steps = lattice.step;
    LatticeTrial trial = trials.try_lattice(lattice, bounds);
    const double load = bounds.load(trial.quality);
    const bool kept = load <= 1;
    if (kept && step > best_step) {
      best = std::move(trial);
      best_step = step;
    }
    if (kept && (load > kCloseEnough || load == 0 || trials.effort() == 0)) break;
    // A bound far off asks for bold steps, since coordinates rounded to floats add to the error.
    step *= std::clamp(0.9995 / std::max(load, 1e-9), 0.25, 4.0);
  }
  return best;
}

std::optional<LatticeTrial> keep_on_voxels(const Bounds& bounds, const VoxelFit& fit,
                                           const PredictiveTrials& trials) {
  const double voxel = *std::max_element(fit.voxel.begin(), fit.voxel.end());
  // A vertex is off along its edge only, which is 2 levels' halves; see first_step().
  const double step = first_step(bounds, trials.source().box) * std::sqrt(3.0);
  std::uint32_t enough = kMostLevels + 1;
  std::uint32_t too_few = 0;
  std::optional<LatticeTrial> best;
  double levels = std::ceil(voxel / step);
  for (int i = 0; i < kMostTrials && enough - too_few > 1; ++i) {
    const auto now = static_cast<std::uint32_t>(std::clamp(levels, too_few + 1.0, enough - 1.0));
    auto trial = trials.try_levels(fit, now, bounds);
    if (!trial) {  // more than the grid has room for
      enough = now;
      levels = too_few + (now - too_few) / 2.0;
      continue;
    }
    const double load = bounds.load(trial->quality);
    if (load <= 1) {
      best = std::move(trial);
      enough = now;
      levels = std::max(std::ceil(now * load), now / 4.0);
      if (trials.effort() == 0 && levels >= now) break;
    } else {
      too_few = now;
      levels = std::ceil(now * std::min(load, 4.0));
    }
    if (levels == now) levels = now + (load <= 1 ? -1.0 : 1.0);
  }
  return best;
}

/// As many levels as the starting states know, if these keep the bounds.
std::optional<LatticeTrial> keep_usual_levels(const Bounds& bounds, const VoxelFit& fit,
                                              const PredictiveTrials& trials) {
  if (trials.usual_levels() == 0) return std::nullopt;
  auto trial = trials.try_levels(fit, trials.usual_levels(), bounds);
  if (trial && bounds.load(trial->quality) > 1) trial.reset();
  return trial;
}

/// Whether most vertices are on edges of voxels that are not much finer than the bounds' lattice, and faces
/// no larger.
bool are_voxels_enough(const Bounds& bounds, const PredictiveTrials& trials) {
  constexpr double kMostly = 0.5;      // of the vertices on edges
  constexpr double kMuchFiner = 0.25;  // than the lattice: then a plane of voxels means nothing
  if (!trials.voxels() || trials.voxels()->share <= kMostly) return false;
  const double voxel = *std::max_element(trials.voxels()->voxel.begin(), trials.voxels()->voxel.end());
  return voxel > kMuchFiner * first_step(bounds, trials.source().box) &&
         faces_fit_cubes(trials.source().triangles, trials.source().positions, voxel);
}

Result<CodedGeometry> fit_lattice(std::uint64_t bytes, const PredictiveTrials& trials) {
  const Box& box = trials.source().box;
  const double count = static_cast<double>(std::max<std::size_t>(trials.source().positions.size(), 1));
  const double finest = std::max(finest_step(box), 1e-30);
  const double coarsest = 2 * std::max(box.longest_side(), 1e-30);  // all coordinates are 0
  std::optional<CodedGeometry> best;
  double fit = coarsest * 2;
  double too_fine = finest / 2;
  double step = trials.step_for_bits(12);
  std::uint64_t fewest = ~std::uint64_t{0};
  for (int i = 0; i < kMostTrials; ++i) {
    if (i + 1 == kMostTrials && !best) step = coarsest;
    auto choice = trials.code(trials.try_lattice(cubic_lattice(box, short_float_below(step))));
    const std::uint64_t size = trials.bytes_with(choice);
    fewest = std::min(fewest, size);
    const bool fits = size <= bytes;
    if (fits && step < fit) {
      best = std::move(choice);
      fit = step;
    }
    if (!fits) too_fine = std::max(too_fine, step);
    // Three coordinates cost a bit less each where the step doubles.
    const double bits = 8 * (static_cast<double>(size) - static_cast<double>(bytes)) / (3 * count);
    if ((fits && (bits > -0.003 || step <= finest)) || (!fits && step >= coarsest)) break;
    step *= portable_exp2(std::clamp(bits + (fits ? 0 : 0.002), -6.0, 6.0));
    // Never back to where it is known how it ends; where bits are few they say little.
    if (step >= fit || step <= too_fine) step = std::sqrt(fit * too_fine);
    step = std::clamp(step, finest, coarsest);
  }
  if (!best) return too_few_bytes(fewest);
  return *std::move(best);
}

std::optional<CodedGeometry> fit_voxel_levels(std::uint64_t bytes, const VoxelFit& voxels,
                                              const PredictiveTrials& trials) {
  const double count = static_cast<double>(std::max<std::size_t>(trials.source().positions.size(), 1));
  std::optional<CodedGeometry> best;
  std::uint32_t fit = 0;
  std::uint32_t too_many = kMostLevels + 1;
  double levels = 8;
  for (int i = 0; i < kMostTrials && too_many - fit > 1; ++i) {
    const auto now = static_cast<std::uint32_t>(std::clamp(std::round(levels), fit + 1.0, too_many - 1.0));
    const auto trial = trials.try_levels(voxels, now);
    if (!trial) {  // more than the grid has room for
      too_many = now;
      levels = fit + (now - fit) / 2.0;
      continue;
    }
    auto choice = trials.code(*trial);
    const std::uint64_t size = trials.bytes_with(choice);
    if (size <= bytes) {
      best = std::move(choice);
      fit = now;
    } else {
      too_many = now;
    }
    // One coordinate costs a bit more where the levels double.
    const double bits = 8 * (static_cast<double>(bytes) - static_cast<double>(size)) / count;
    levels = now * portable_exp2(std::clamp(bits, -6.0, 6.0));
  }
  return best;
}

}  // namespace

bool suits_predictive(const Bounds& bounds, const PredictiveTrials& trials) {
  const SourceGeometry& source = trials.source();
  if (!bounds.vde || first_step(bounds, source.box) < first_step({.vde = bounds.vde}, source.box))
    return true;
  const FaceList faces{source.triangles, static_cast<std::uint32_t>(source.positions.size())};
  return are_voxels_enough(bounds, trials) ||
         forecast_coders(source.graph.graph(), faces, source.positions, *bounds.vde).predictive_wins();
}

CodedGeometry keep_bounds(const Bounds& bounds, const PredictiveTrials& trials) {
  std::optional<CodedGeometry> best;
  const auto keep_smaller = [&](const std::optional<LatticeTrial>& trial) {
    if (!trial) return;
    CodedGeometry geometry = trials.code(*trial);
    if (!best || trials.bytes_with(geometry) < trials.bytes_with(*best)) best = std::move(geometry);
  };
  const double step = first_step(bounds, trials.source().box);
  if (trials.voxels() && (trials.effort() > 0 || are_voxels_enough(bounds, trials))) {
    keep_smaller(keep_on_voxels(bounds, *trials.voxels(), trials));
    keep_smaller(keep_usual_levels(bounds, *trials.voxels(), trials));
  } else if (const auto axes = trials.axes(step / 8); has_grid(axes, step)) {
    // Axes of their own come first: effort 0 takes them, others compare.
    keep_smaller(keep_on_lattice(bounds, axes, trials));
  }
  if (best && trials.effort() == 0) return *std::move(best);
  keep_smaller(keep_on_lattice(bounds, {}, trials));
  // Lattices end where floats do.
  return best ? *std::move(best) : trials.code_exactly();
}

Result<CodedGeometry> fit_bytes(std::uint64_t bytes, const PredictiveTrials& trials) {
  if (auto exact = trials.code_exactly(); trials.bytes_with(exact) <= bytes) return exact;
  auto on_lattice = fit_lattice(bytes, trials);
  if (!trials.voxels()) return on_lattice;
  auto on_voxels = fit_voxel_levels(bytes, *trials.voxels(), trials);
  if (!on_voxels) return on_lattice;
  if (!on_lattice || on_voxels->quality.vde_rms < on_lattice->quality.vde_rms) return *std::move(on_voxels);
  return on_lattice;
}

}  // namespace deltamesh
