// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "quality/visual_control.h"

#include <cmath>

#include "base/try.h"

namespace deltamesh {
namespace {

/// VDE over the delta error.
constexpr double kVdePerDeltaError = 0.76;
/// What full diffusion adds to the delta error.
constexpr double kDiffusionCost = 0.14;

/// Above so many bits (of the range) rounding to the nearest is best.
constexpr double kLowRateBits = 7;
constexpr double kRoundings[] = {0.45, 0.4, 0.35, 0.3};
constexpr int kRoundingEffort = 3;

}  // namespace

double step_from_vde(TrialCoder& coder, const CoderSettings& settings, double vde) {
  const double diffused = 1 + kDiffusionCost * settings.diffusion;
  CoderSettings plain = settings;  // many times as quick to measure
  plain.diffusion = 0;
  return step_for_delta_error(coder, plain, vde / (kVdePerDeltaError * diffused));
}

StepGoal step_goal(int effort) noexcept {
  if (effort <= 1) return {.aim = 0.9, .tight = 0, .corrections = 0};
  if (effort <= 6) return {};
  return {.aim = 0.99, .tight = 0.98, .corrections = 7};
}

Result<CoderSettings> choose_rounding(TrialCoder& coder, CoderSettings settings, double vde, int effort) {
  settings.step = step_from_vde(coder, settings, vde);
  const bool low_rate = std::log2(coder.delta_range() / settings.step) < kLowRateBits;
  if (effort < kRoundingEffort || !low_rate) return settings;
  DELTAMESH_TRY(std::uint64_t fewest, coder.bytes(settings));
  CoderSettings best = settings;
  for (const double rounding : kRoundings) {
    settings.rounding = rounding;
    settings.step = step_from_vde(coder, settings, vde);
    DELTAMESH_TRY(const std::uint64_t bytes, coder.bytes(settings));
    if (bytes >= fewest) break;
    fewest = bytes;
    best = settings;
  }
  return best;
}

Result<void> control_visual(const RateGoal& goal, CoderSettings settings, Trials& trials) {
  const StepGoal near = step_goal(goal.effort);
  settings.step = trials.coder().longest_side() / 1024;
  DELTAMESH_TRY(const CoderSettings chosen,
                choose_rounding(trials.coder(), settings, near.aim * *goal.bounds.vde, goal.effort));
  DELTAMESH_TRY(const Attempt landed, search_step(trials, chosen, Watch::kAll, near));
  const bool all_zero = landed.settings.step >= coarsest_step(trials.coder(), landed.settings.rounding);
  if (!all_zero || goal.anchors || goal.effort <= 1) return {};
  CoderSettings fewest = landed.settings;  // nothing but anchors is left to be saved
  fewest.anchors = trials.coder().fewest_anchors();
  DELTAMESH_TRY([[maybe_unused]] const Attempt last, trials.run(fewest));
  return {};
}

}  // namespace deltamesh
