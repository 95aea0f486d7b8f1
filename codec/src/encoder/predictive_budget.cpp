// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "encoder/predictive_budget.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "base/short_float.h"
#include "predictive/lattice.h"
#include "quality/unmet.h"

namespace deltamesh {
namespace {

constexpr int kMostTrials = 10;

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
