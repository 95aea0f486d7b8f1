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

PredictiveTrials::PredictiveTrials(const PredictiveInput& input, const StreamFrame& frame)
    : input_(input),
      frame_(frame),
      stars_(input.triangles, static_cast<std::uint32_t>(input.positions.size())) {}

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

Result<PredictiveTrials::Trial> PredictiveTrials::try_step(double step) const {
  Trial trial{.lattice = cubic_lattice(input_.box, step), .cells = {}, .quality = {}};
  trial.cells = to_cells(input_.positions, trial.lattice);
  DELTAMESH_TRY(const auto decoded, to_float_positions(to_positions(trial.cells, trial.lattice)));
  trial.quality = measure_quality(input_.graph, input_.positions, decoded);
  return trial;
}

Result<GeometryChoice> PredictiveTrials::code(Trial trial) const {
  GeometryChoice choice{.geometry = kGeometryPredictive,
                        .predictive = {.lattice = trial.lattice},
                        .chunks = frame_.before.fresh(),
                        .quality = trial.quality};
  choice.chunks.add_compact(kTagPositions, write_positions(stars_, trial.cells, trial.lattice));
  return choice;
}

Result<GeometryChoice> PredictiveTrials::code_step(double step) const {
  DELTAMESH_TRY(auto trial, try_step(step));
  return code(std::move(trial));
}

Result<GeometryChoice> PredictiveTrials::keep_bounds(const Bounds& bounds, int effort) const {
  std::optional<Trial> best;
  double step = first_step(bounds);
  for (int i = 0; i < kMostTrials; ++i) {
    DELTAMESH_TRY(auto trial, try_step(step));
    const double load = bounds.load(trial.quality);
    const bool kept = load <= 1;
    if (kept && (!best || trial.lattice.step[0] > best->lattice.step[0])) best = std::move(trial);
    if (kept && (load > kCloseEnough || load == 0 || effort == 0)) break;
    if (!kept && i + 1 == kMostTrials && !best) {
      DELTAMESH_TRY(const auto coded, code(trial));
      return unmet_bound(bounds, coded.quality, frame_.bytes_with(coded));
    }
    // A bound far off asks for bold steps, since coordinates rounded to floats add to the error.
    step *= std::clamp(0.9995 / std::max(load, 1e-9), 0.25, 4.0);
  }
  return code(*std::move(best));
}

Result<GeometryChoice> PredictiveTrials::fit_bytes(std::uint64_t bytes) const {
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

}  // namespace deltamesh
