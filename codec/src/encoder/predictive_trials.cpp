// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "encoder/predictive_trials.h"

#include <algorithm>
#include <cmath>

#include "base/try.h"
#include "geometry/vertex_positions.h"
#include "predictive/lattice.h"
#include "predictive/positions.h"
#include "quality/measure.h"

namespace deltamesh {
namespace {

constexpr int kMostTrials = 10;
constexpr double kCloseEnough = 0.997;  ///< share of a bound that needs no better trial

Error unmet(const char* message, double best_value, std::uint64_t best_bytes) noexcept {
  return {.code = ErrorCode::kUnmetRequest,
          .message = message,
          .best_value = best_value,
          .best_bytes = best_bytes};
}

/// What to say where not even the finest lattice will do.
Error unmet_bound(const Bounds& bounds, const Quality& best, std::uint64_t bytes) noexcept {
  if (bounds.vde && bounds.visual_load(best) >= bounds.load(best))
    return unmet("the VDE asked for cannot be had for this mesh", best.vde_rms, bytes);
  if (bounds.lfe && best.lfe_rms / *bounds.lfe >= bounds.load(best))
    return unmet("the LFE asked for cannot be had for this mesh", best.lfe_rms, bytes);
  return unmet("the maximum error asked for cannot be had for this mesh", best.max_error, bytes);
}

}  // namespace

PredictiveTrials::PredictiveTrials(const PredictiveInput& input, const StreamFrame& frame, int effort)
    : input_(input),
      frame_(frame),
      effort_(effort),
      stars_(input.triangles, static_cast<std::uint32_t>(input.positions.size())),
      voxels_(fit_voxels(input.positions, input.box)),
      axes_(voxels_ ? std::array<AxisGrid, 3>{} : fit_axes(input.positions, input.box)) {}

double PredictiveTrials::step_for_bits(int bits) const noexcept {
  const double step = input_.box.longest_side() / (std::ldexp(1.0, bits) - 1);
  return step > 0 ? step : 1.0;
}

double PredictiveTrials::first_step(const Bounds& bounds) const noexcept {
  double step = std::max(input_.box.longest_side(), 1e-30);
  // Half a step per axis is the most; a uniform error of one step has a variance of 1/12, and a vertex's
  // neighbours add a little to what is seen at it.
  if (bounds.max_error) step = std::min(step, 2 / std::sqrt(3.0) * *bounds.max_error);
  if (bounds.lfe) step = std::min(step, 2 * *bounds.lfe);
  if (bounds.vde) step = std::min(step, 1.85 * *bounds.vde);
  return step > 0 ? step : 1.0;  // a bound in percent of nothing
}

Result<PredictiveTrials::Trial> PredictiveTrials::measured(PredictiveParameters parameters,
                                                           std::vector<Cell> cells) const {
  DELTAMESH_TRY(const auto decoded, to_float_positions(to_positions(cells, parameters.lattice)));
  return Trial{parameters, std::move(cells), measure_quality(input_.graph, input_.positions, decoded)};
}

Result<PredictiveTrials::Trial> PredictiveTrials::try_step(double step, bool on_grid) const {
  const PositionLattice lattice =
      on_grid ? grid_lattice(input_.box, axes_, step) : cubic_lattice(input_.box, step);
  return measured({.lattice = lattice}, to_cells(input_.positions, lattice));
}

Result<PredictiveTrials::Trial> PredictiveTrials::try_levels(std::uint32_t levels) const {
  auto voxels = to_voxel_cells(input_.positions, input_.box, *voxels_, levels);
  if (!voxels) return unmet("more levels than a voxel may have", 0, 0);
  return measured({.kind = PositionKind::kVoxel, .lattice = voxels->lattice, .levels = levels},
                  std::move(voxels->cells));
}

Result<GeometryChoice> PredictiveTrials::code(const Trial& trial) const {
  GeometryChoice choice{.geometry = kGeometryPredictive,
                        .predictive = trial.parameters,
                        .chunks = frame_.before.fresh(),
                        .quality = trial.quality};
  auto bytes = write_positions(stars_, trial.cells, trial.parameters);
  if (effort_ > 0 && trial.parameters.kind == PositionKind::kLattice) {
    auto guessed = write_positions(stars_, trial.cells, trial.parameters, true);
    if (guessed.size() < bytes.size()) bytes = std::move(guessed);
  }
  choice.chunks.add_compact(kTagPositions, std::move(bytes));
  return choice;
}

Result<GeometryChoice> PredictiveTrials::code_step(double step) const {
  DELTAMESH_TRY(const auto trial, try_step(step));
  return code(trial);
}

Result<GeometryChoice> PredictiveTrials::code_exactly() const {
  GeometryChoice choice{.geometry = kGeometryPredictive,
                        .predictive = {.kind = PositionKind::kFloats, .lattice = {}},
                        .chunks = frame_.before.fresh()};
  choice.chunks.add_compact(kTagPositions, write_floats(stars_, input_.positions, input_.box));
  return choice;
}

Result<PredictiveTrials::Trial> PredictiveTrials::keep_on_lattice(const Bounds& bounds, bool on_grid) const {
  std::optional<Trial> best;
  double best_step = 0;
  double step = first_step(bounds);
  for (int i = 0; i < kMostTrials; ++i) {
    DELTAMESH_TRY(auto trial, try_step(step, on_grid));
    const double load = bounds.load(trial.quality);
    const bool kept = load <= 1;
    if (!kept && i + 1 == kMostTrials && !best) {
      DELTAMESH_TRY(const auto coded, code(trial));
      return unmet_bound(bounds, coded.quality, frame_.bytes_with(coded));
    }
    if (kept && step > best_step) {
      best = std::move(trial);
      best_step = step;
    }
    if (kept && (load > kCloseEnough || load == 0 || effort_ == 0)) break;
    // A bound far off asks for bold steps, since coordinates rounded to floats add to the error.
    step *= std::clamp(0.9995 / std::max(load, 1e-9), 0.25, 4.0);
  }
  return *std::move(best);
}

Result<PredictiveTrials::Trial> PredictiveTrials::keep_on_voxels(const Bounds& bounds) const {
  const double voxel = *std::max_element(voxels_->voxel.begin(), voxels_->voxel.end());
  // A vertex is off along its edge only, which is 2 levels' halves; see first_step().
  const double step = first_step(bounds) * std::sqrt(3.0);
  std::uint32_t enough = kMostLevels + 1;
  std::uint32_t too_few = 0;
  std::optional<Trial> best;
  double levels = std::ceil(voxel / step);
  for (int i = 0; i < kMostTrials && enough - too_few > 1; ++i) {
    const auto now = static_cast<std::uint32_t>(std::clamp(levels, too_few + 1.0, enough - 1.0));
    DELTAMESH_TRY(auto trial, try_levels(now));
    const double load = bounds.load(trial.quality);
    if (load <= 1) {
      best = std::move(trial);
      enough = now;
      levels = std::max(std::ceil(now * load), now / 4.0);
    } else {
      too_few = now;
      levels = std::ceil(now * std::min(load, 4.0));
    }
    if (levels == now) levels = now + (load <= 1 ? -1.0 : 1.0);
  }
  if (!best) return unmet("not on voxels", 0, 0);
  return *std::move(best);
}

Result<GeometryChoice> PredictiveTrials::keep_bounds(const Bounds& bounds) const {
  constexpr double kMostly = 0.5;  // of the vertices on edges: the voxels win
  std::optional<GeometryChoice> on_voxels;
  if (voxels_) {
    if (const auto trial = keep_on_voxels(bounds)) {
      DELTAMESH_TRY(on_voxels, code(*trial));
      if (effort_ == 0 && voxels_->share > kMostly) return *std::move(on_voxels);
    }
  }
  // Axes of their own come first: effort 0 takes them, others compare.
  std::optional<GeometryChoice> best = std::move(on_voxels);
  const bool has_grid =
      std::any_of(axes_.begin(), axes_.end(), [](const AxisGrid& axis) { return axis.step > 0; });
  for (const bool on_grid : {true, false}) {
    if ((on_grid && !has_grid) || (!on_grid && best && has_grid && effort_ == 0)) continue;
    const auto trial = keep_on_lattice(bounds, on_grid);
    if (!trial) continue;
    DELTAMESH_TRY(auto choice, code(*trial));
    if (!best || frame_.bytes_with(choice) < frame_.bytes_with(*best)) best = std::move(choice);
  }
  // Lattices end where floats do.
  return best ? *std::move(best) : code_exactly();
}

Result<GeometryChoice> PredictiveTrials::fit_bytes(std::uint64_t bytes) const {
  auto on_lattice = fit_lattice(bytes);
  if (!voxels_) return on_lattice;
  auto on_voxels = fit_voxel_levels(bytes);
  if (!on_voxels) return on_lattice;
  if (!on_lattice || on_voxels->quality.vde_rms < on_lattice->quality.vde_rms) return on_voxels;
  return on_lattice;
}

Result<GeometryChoice> PredictiveTrials::fit_lattice(std::uint64_t bytes) const {
  const double count = static_cast<double>(std::max<std::size_t>(input_.positions.size(), 1));
  std::optional<GeometryChoice> best;
  double best_step = 0;
  double step = step_for_bits(12);
  std::uint64_t fewest = ~std::uint64_t{0};
  for (int i = 0; i < kMostTrials; ++i) {
    DELTAMESH_TRY(auto choice, code_step(step));
    const std::uint64_t size = frame_.bytes_with(choice);
    fewest = std::min(fewest, size);
    const bool fits = size <= bytes;
    if (fits && (!best || step < best_step)) {
      best = std::move(choice);
      best_step = step;
    }
    // Three coordinates cost a bit less each where the step doubles.
    const double bits = 8 * (static_cast<double>(size) - static_cast<double>(bytes)) / (3 * count);
    if (fits && bits > -0.003) break;
    step *= std::exp2(std::clamp(bits + (fits ? 0 : 0.002), -6.0, 6.0));
    step = std::min(step, 2 * std::max(input_.box.longest_side(), 1e-30));
  }
  if (!best) return unmet("no stream of this mesh is so small", 0, fewest);
  return *std::move(best);
}

Result<GeometryChoice> PredictiveTrials::fit_voxel_levels(std::uint64_t bytes) const {
  const double count = static_cast<double>(std::max<std::size_t>(input_.positions.size(), 1));
  std::optional<GeometryChoice> best;
  std::uint32_t fit = 0;
  std::uint32_t too_many = kMostLevels + 1;
  double levels = 8;
  for (int i = 0; i < kMostTrials && too_many - fit > 1; ++i) {
    const auto now = static_cast<std::uint32_t>(std::clamp(std::round(levels), fit + 1.0, too_many - 1.0));
    DELTAMESH_TRY(const auto trial, try_levels(now));
    DELTAMESH_TRY(auto choice, code(trial));
    const std::uint64_t size = frame_.bytes_with(choice);
    if (size <= bytes) {
      best = std::move(choice);
      fit = now;
    } else {
      too_many = now;
    }
    // One coordinate costs a bit more where the levels double.
    const double bits = 8 * (static_cast<double>(bytes) - static_cast<double>(size)) / count;
    levels = now * std::exp2(std::clamp(bits, -6.0, 6.0));
  }
  if (!best) return unmet("no stream of this mesh is so small", 0, 0);
  return *std::move(best);
}

}  // namespace deltamesh
