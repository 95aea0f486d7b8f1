// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "encoder/predictive_trials.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "base/short_float.h"
#include "base/try.h"
#include "encoder/cell_quality.h"
#include "encoder/coder_forecast.h"
#include "encoder/position_forms.h"
#include "predictive/exact_lattice.h"
#include "predictive/lattice.h"
#include "predictive/positions.h"
#include "quality/unmet.h"

namespace deltamesh {
namespace {

constexpr int kMostTrials = 10;
constexpr std::size_t kQuickSample = 1U << 15;  ///< vertices that effort 0 looks for grids in
constexpr double kCloseEnough = 0.997;          ///< share of a bound that needs no better trial

/// Whether an axis has a grid, and grid_lattice() at `step` or a little above would take it.
bool has_grid(const std::array<AxisGrid, 3>& axes, double step) noexcept {
  return std::any_of(axes.begin(), axes.end(), [step](const AxisGrid& axis) { return axis.step > step / 2; });
}

/// n x 3.
std::vector<float> to_rows(std::span<const Vec3> positions) {
  std::vector<float> rows;
  rows.reserve(3 * positions.size());
  for (const Vec3& position : positions)
    for (const double x : position) rows.push_back(static_cast<float>(x));
  return rows;
}

}  // namespace

PredictiveTrials::PredictiveTrials(const EncodeOptions& options, const SourceGeometry& source,
                                   const StreamRest& rest)
    : options_(options),
      source_(source),
      rest_(rest),
      faces_{source.triangles, static_cast<std::uint32_t>(source.positions.size())},
      values_(source.positions, options.effort == 0 ? kQuickSample : source.positions.size()) {}

double PredictiveTrials::step_for_bits(int bits) const noexcept {
  const double step = source_.box.longest_side() / (std::ldexp(1.0, bits) - 1);
  return step > 0 ? std::max(step, finest_step(source_.box)) : 1.0;
}

double PredictiveTrials::first_step(const Bounds& bounds) const noexcept {
  double step = std::max(source_.box.longest_side(), 1e-30);
  // Half a step per axis is the most; a uniform error of one step has a variance of 1/12, and a vertex's
  // neighbours add a little to what is seen at it.
  if (bounds.max_error) step = std::min(step, 2 / std::sqrt(3.0) * *bounds.max_error);
  if (bounds.lfe) step = std::min(step, 2 * *bounds.lfe);
  if (bounds.vde) step = std::min(step, 1.85 * *bounds.vde);
  return step > 0 ? step : 1.0;  // a bound in percent of nothing
}

PredictiveTrials::Trial PredictiveTrials::measured(PredictiveParameters parameters, std::vector<Cell> cells,
                                                   const Bounds& bounds) const {
  Trial trial{.parameters = parameters, .cells = std::move(cells)};
  trial.quality = positional_quality(source_.positions, trial.cells, parameters.lattice, source_.edges);
  if (bounds.vde && is_declarable(trial.quality))
    trial.quality.vde_rms = visual_error(source_.edges, source_.positions, trial.cells, parameters.lattice);
  return trial;
}

PredictiveTrials::Trial PredictiveTrials::try_lattice(const PositionLattice& lattice,
                                                      const Bounds& bounds) const {
  return measured({.lattice = lattice}, to_cells(source_.positions, lattice), bounds);
}

std::optional<PredictiveTrials::Trial> PredictiveTrials::try_levels(const VoxelFit& fit, std::uint32_t levels,
                                                                    const Bounds& bounds) const {
  auto voxels = to_voxel_cells(source_.positions, source_.box, fit, levels);
  if (!voxels) return std::nullopt;
  return measured({.kind = PositionKind::kVoxel, .lattice = voxels->lattice, .levels = levels},
                  std::move(voxels->cells), bounds);
}

CodedGeometry PredictiveTrials::code(const Trial& trial) const {
  CodedGeometry choice{.coder = kGeometryPredictive,
                       .predictive = trial.parameters,
                       .chunks = ChunkList(options_),
                       .quality = trial.quality};
  if (!(choice.quality.vde_rms > 0) && choice.quality.lfe_rms > 0 && is_declarable(choice.quality))
    choice.quality.vde_rms =
        visual_error(source_.edges, source_.positions, trial.cells, trial.parameters.lattice);
  const auto write = [&](const PositionForm& form) {
    return write_positions(faces_, trial.cells, trial.parameters, form, trial.patches);
  };
  choice.chunks.add_compact(kTagPositions, write_smallest(write, trial.parameters.kind, options_.effort));
  choice.positions = to_rows(to_positions(trial.cells, trial.parameters.lattice));
  deltamesh::apply(trial.patches, std::span<float>(choice.positions));
  return choice;
}

Result<CodedGeometry> PredictiveTrials::code_step(double step) const {
  if (step < finest_step(source_.box))
    return Error{.code = ErrorCode::kInvalidArgument,
                 .message = "a step so fine takes over 2^28 points along a side; `lossless` keeps every bit"};
  return code(try_lattice(cubic_lattice(source_.box, step)));
}

CodedGeometry PredictiveTrials::code_floats() const {
  CodedGeometry choice{.coder = kGeometryPredictive,
                       .predictive = {.kind = PositionKind::kFloats, .lattice = {}},
                       .chunks = ChunkList(options_)};
  const auto write = [&](const PositionForm& form) {
    return write_floats(faces_, source_.positions, source_.box, form);
  };
  choice.chunks.add_compact(kTagPositions, write_smallest(write, PositionKind::kFloats, options_.effort));
  choice.positions = to_rows(source_.positions);
  return choice;
}

CodedGeometry PredictiveTrials::code_exactly() const {
  CodedGeometry floats = code_floats();
  const auto lattice = find_exact_lattice(source_.positions, source_.box);
  if (!lattice) return floats;
  Trial trial{.parameters = {.lattice = *lattice}, .cells = to_cells(source_.positions, *lattice)};
  trial.patches = find_patches(source_.positions, to_positions(trial.cells, *lattice));
  CodedGeometry choice = code(trial);
  return rest_.bytes_with(choice) < rest_.bytes_with(floats) ? choice : floats;
}

std::optional<PredictiveTrials::Trial> PredictiveTrials::keep_on_lattice(
    const Bounds& bounds, const std::array<AxisGrid, 3>& axes) const {
  std::optional<Trial> best;
  double best_step = 0;
  double step = first_step(bounds);
  std::array<double, 3> last_steps{};
  for (int i = 0; i < kMostTrials; ++i) {
    const PositionLattice lattice = grid_lattice(source_.box, axes, short_float_below(step));
    if (lattice.step == last_steps) break;
    last_steps = lattice.step;
    Trial trial = try_lattice(lattice, bounds);
    const double load = bounds.load(trial.quality);
    const bool kept = load <= 1;
    if (kept && step > best_step) {
      best = std::move(trial);
      best_step = step;
    }
    if (kept && (load > kCloseEnough || load == 0 || options_.effort == 0)) break;
    // A bound far off asks for bold steps, since coordinates rounded to floats add to the error.
    step *= std::clamp(0.9995 / std::max(load, 1e-9), 0.25, 4.0);
  }
  return best;
}

std::optional<PredictiveTrials::Trial> PredictiveTrials::keep_on_voxels(const Bounds& bounds,
                                                                        const VoxelFit& fit) const {
  const double voxel = *std::max_element(fit.voxel.begin(), fit.voxel.end());
  // A vertex is off along its edge only, which is 2 levels' halves; see first_step().
  const double step = first_step(bounds) * std::sqrt(3.0);
  std::uint32_t enough = kMostLevels + 1;
  std::uint32_t too_few = 0;
  std::optional<Trial> best;
  double levels = std::ceil(voxel / step);
  for (int i = 0; i < kMostTrials && enough - too_few > 1; ++i) {
    const auto now = static_cast<std::uint32_t>(std::clamp(levels, too_few + 1.0, enough - 1.0));
    auto trial = try_levels(fit, now, bounds);
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
      if (options_.effort == 0 && levels >= now) break;
    } else {
      too_few = now;
      levels = std::ceil(now * std::min(load, 4.0));
    }
    if (levels == now) levels = now + (load <= 1 ? -1.0 : 1.0);
  }
  return best;
}

const std::optional<VoxelFit>& PredictiveTrials::voxels() const {
  if (!voxels_) voxels_ = fit_voxels(values_, source_.box);
  return *voxels_;
}

bool PredictiveTrials::are_voxels_enough(const Bounds& bounds) const {
  constexpr double kMostly = 0.5;      // of the vertices on edges
  constexpr double kMuchFiner = 0.25;  // than the lattice: then a plane of voxels means nothing
  if (!voxels() || voxels()->share <= kMostly) return false;
  const double voxel = *std::max_element(voxels()->voxel.begin(), voxels()->voxel.end());
  return voxel > kMuchFiner * first_step(bounds) &&
         faces_fit_cubes(source_.triangles, source_.positions, voxel);
}

bool PredictiveTrials::suits(const Bounds& bounds) const {
  if (!bounds.vde || first_step(bounds) < first_step({.vde = bounds.vde})) return true;
  return are_voxels_enough(bounds) ||
         forecast_coders(source_.graph.graph(), faces_, source_.positions, *bounds.vde).predictive_wins();
}

Result<CodedGeometry> PredictiveTrials::keep_bounds(const Bounds& bounds) const {
  std::optional<CodedGeometry> best;
  const auto keep_smaller = [&](CodedGeometry choice) {
    if (!best || rest_.bytes_with(choice) < rest_.bytes_with(*best)) best = std::move(choice);
  };
  if (voxels() && (options_.effort > 0 || are_voxels_enough(bounds))) {
    if (const auto trial = keep_on_voxels(bounds, *voxels())) keep_smaller(code(*trial));
    if (best && options_.effort == 0) return *std::move(best);
  } else if (const auto axes = fit_axes(values_, source_.box, first_step(bounds) / 8);
             has_grid(axes, first_step(bounds))) {
    // Axes of their own come first: effort 0 takes them, others compare.
    if (const auto trial = keep_on_lattice(bounds, axes)) keep_smaller(code(*trial));
    if (best && options_.effort == 0) return *std::move(best);
  }
  if (const auto trial = keep_on_lattice(bounds, {})) keep_smaller(code(*trial));
  // Lattices end where floats do.
  return best ? *std::move(best) : code_exactly();
}

Result<CodedGeometry> PredictiveTrials::fit_bytes(std::uint64_t bytes) const {
  if (auto exact = code_exactly(); rest_.bytes_with(exact) <= bytes) return exact;
  auto on_lattice = fit_lattice(bytes);
  if (!voxels()) return on_lattice;
  auto on_voxels = fit_voxel_levels(bytes, *voxels());
  if (!on_voxels) return on_lattice;
  if (!on_lattice || on_voxels->quality.vde_rms < on_lattice->quality.vde_rms) return *std::move(on_voxels);
  return on_lattice;
}

Result<CodedGeometry> PredictiveTrials::fit_lattice(std::uint64_t bytes) const {
  const double count = static_cast<double>(std::max<std::size_t>(source_.positions.size(), 1));
  const double finest = std::max(finest_step(source_.box), 1e-30);
  const double coarsest = 2 * std::max(source_.box.longest_side(), 1e-30);  // all coordinates are 0
  std::optional<CodedGeometry> best;
  double fit = coarsest * 2;
  double too_fine = finest / 2;
  double step = step_for_bits(12);
  std::uint64_t fewest = ~std::uint64_t{0};
  for (int i = 0; i < kMostTrials; ++i) {
    if (i + 1 == kMostTrials && !best) step = coarsest;
    auto choice = code(try_lattice(cubic_lattice(source_.box, short_float_below(step))));
    const std::uint64_t size = rest_.bytes_with(choice);
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

std::optional<CodedGeometry> PredictiveTrials::fit_voxel_levels(std::uint64_t bytes,
                                                                const VoxelFit& voxels) const {
  const double count = static_cast<double>(std::max<std::size_t>(source_.positions.size(), 1));
  std::optional<CodedGeometry> best;
  std::uint32_t fit = 0;
  std::uint32_t too_many = kMostLevels + 1;
  double levels = 8;
  for (int i = 0; i < kMostTrials && too_many - fit > 1; ++i) {
    const auto now = static_cast<std::uint32_t>(std::clamp(std::round(levels), fit + 1.0, too_many - 1.0));
    const auto trial = try_levels(voxels, now);
    if (!trial) {  // more than the grid has room for
      too_many = now;
      levels = fit + (now - fit) / 2.0;
      continue;
    }
    auto choice = code(*trial);
    const std::uint64_t size = rest_.bytes_with(choice);
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

}  // namespace deltamesh
