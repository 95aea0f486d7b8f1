// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/visual_control.h"

#include "base/numbers/portable_math.h"
#include "base/try.h"
#include "search/unmet.h"

namespace deltamesh {
namespace {

/// VDE over the delta error.
constexpr double kVdePerDeltaError = 0.76;
/// What full diffusion adds to the delta error.
constexpr double kDiffusionCost = 0.14;

/// Above so many bits (of the range) the nearest symbols are best.
constexpr double kLowRateBits = 7;

}  // namespace

double step_from_vde(TrialCoder& coder, const HighpassSettings& settings, double vde) {
  const double diffused = 1 + kDiffusionCost * settings.diffusion;
  const double delta_error = vde / (kVdePerDeltaError * diffused);
  HighpassSettings plain = settings;  // many times as quick to measure
  plain.diffusion = 0;
  plain.rate_weight = 0;
  plain.step = step_for_delta_error(coder, plain, delta_error);
  plain.rate_weight = settings.rate_weight;
  return step_for_delta_error(coder, plain, delta_error);
}

StepGoal step_goal(int effort) noexcept {
  if (effort <= 1) return {.aim = 0.9, .tight = 0, .corrections = 0};
  if (effort <= 6) return {};
  return {.aim = 0.99, .tight = 0.98, .corrections = 7};
}

HighpassSettings settings_for_vde(TrialCoder& coder, HighpassSettings settings, double vde, int effort) {
  settings.step = step_from_vde(coder, settings, vde);
  const bool low_rate = portable_log2(coder.delta_range() / settings.step) < kLowRateBits;
  if (effort < kFrugalEffort || !low_rate) return settings;
  settings.rate_weight = kRateWeight;
  settings.step = step_from_vde(coder, settings, vde);
  return settings;
}

Result<void> control_visual(HighpassSettings settings, Trials& trials) {
  const RateGoal& goal = trials.goal();
  const StepGoal near = step_goal(goal.effort);
  settings.step = trials.coder().longest_side() / 1024;
  const HighpassSettings chosen =
      settings_for_vde(trials.coder(), settings, near.aim * *goal.bounds.vde, goal.effort);
  DELTAMESH_CHECK(check_rival(chosen, trials));
  DELTAMESH_TRY(const Attempt landed, search_step(trials, chosen, Watch::kAll, near));
  const bool all_zero = landed.settings.step >= coarsest_step(trials.coder());
  if (!all_zero || goal.anchors || goal.effort <= 1) return {};
  HighpassSettings fewest = landed.settings;  // nothing but anchors is left to be saved
  fewest.anchors = trials.coder().fewest_anchors();
  DELTAMESH_TRY([[maybe_unused]] const Attempt last, trials.run(fewest));
  return {};
}

}  // namespace deltamesh
