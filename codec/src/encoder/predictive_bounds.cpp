// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "encoder/predictive_bounds.h"

#include <algorithm>
#include <cmath>

#include "base/short_float.h"
#include "encoder/cell_quality.h"
#include "encoder/coder_forecast.h"

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

}  // namespace deltamesh
