// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/positional_control.h"

#include <algorithm>

#include "base/try.h"
#include "search/peak_control.h"
#include "search/step_search.h"
#include "search/thinning.h"
#include "search/unmet.h"
#include "search/visual_control.h"

namespace deltamesh {
namespace {

constexpr double kPositionalAim = 0.95;
constexpr double kWeak = 0.975;  // loads above ask for more strength, those below for less
constexpr int kMostPositionalRuns = 6;
constexpr double kVisualAim = 0.975;
constexpr double kVisualTight = 0.94;  ///< a smaller visual load leaves room for a larger step
/// What is left of the load at full strength, until it is measured.
constexpr double kFullStrengthLoad = 0.3;
/// From here on the last step is to full strength.
constexpr double kNearlyFull = 0.93;

/// A strength and the positional load found there.
struct Point {
  double strength = 0;
  double load = 0;
};

/// The line through the two points, kept off their ends. LFE falls almost linearly with the strength.
double strength_between(const Point& weak, const Point& strong) noexcept {
  const double share = (weak.load - kPositionalAim) / (weak.load - strong.load);
  return weak.strength + std::clamp(share, 0.05, 0.95) * (strong.strength - weak.strength);
}

/// From `plain`, which keeps VDE without diffusion but not the positional bounds, looks for the strength at
/// which they are just kept; `step_moves` says whether the step is made up for what diffusion adds to VDE. At
/// most 6 runs. Returns the attempt that keeps all bounds, else that of full strength.
Result<Attempt> raise_diffusion(const Attempt& plain, bool step_moves, Trials& trials) {
  if (!plain.decodes()) return plain;
  TrialCoder& coder = trials.coder();
  const Bounds& bounds = trials.bounds();
  const double delta_error = coder.delta_error(plain.settings);
  HighpassSettings settings = plain.settings;
  Point weak{settings.diffusion, bounds.positional_load(plain.figures.quality)};
  Point strong{1, kFullStrengthLoad * weak.load};
  settings.diffusion = strong.load < kPositionalAim ? strength_between(weak, strong) : 1;
  std::optional<Attempt> kept;
  double visual_share = 1;  // what the delta error may be, so that VDE comes near its bound
  for (int runs = 0; runs <= kMostPositionalRuns; ++runs) {
    // Under diffusion what prices save costs more diffusion.
    settings.rate_weight = plain.settings.rate_weight * (1 - settings.diffusion);
    if (step_moves) settings.step = step_for_delta_error(coder, settings, visual_share * delta_error);
    DELTAMESH_TRY(Attempt attempt, trials.run(settings));
    if (!attempt.decodes()) break;
    const double load = bounds.positional_load(attempt.figures.quality);
    const double visual = bounds.visual_load(attempt.figures.quality);
    if (load > 1 && settings.diffusion >= 1) return attempt;  // diffusion alone does not do
    (load > kWeak ? weak : strong) = {settings.diffusion, load};
    const bool near_visual = !step_moves || visual >= kVisualTight;
    if (load <= 1 && visual <= 1) {
      if (!kept || attempt.figures.bytes < kept->figures.bytes) kept = std::move(attempt);
      if (load >= Trials::kLandedLoad && near_visual) break;
    }
    if (visual > 1 || !near_visual) {  // LFE goes with the step as VDE does
      const double change = kVisualAim / visual;
      visual_share *= change;
      weak.load *= change;
      strong.load *= change;
    }
    const bool too_weak = load > 1 && settings.diffusion > kNearlyFull;
    settings.diffusion = too_weak ? 1 : strength_between(weak, strong);
  }
  return kept ? *kept : plain;
}

constexpr int kSearchEffort = 5;
constexpr double kAnchorFactor = 3;
/// What other anchor counts save at most, and a little more.
constexpr double kPositionalRivalShare = 1.08;
/// The step that makes up for this load costs more than a third of the anchors, or three times them, can
/// save.
constexpr double kHopelessPositionalLoad = 1.5;

/// Bytes at a step that is guessed, over what they may be where it is found.
constexpr double kGuessShare = 1.01;

double positional_load(const Trials& trials, const Attempt& attempt) noexcept {
  return trials.bounds().positional_load(attempt.figures.quality);
}

/// Tries more and fewer anchors from `start`, as long as the stream shrinks.
Result<void> explore_anchor_counts(const Attempt& start, Trials& trials) {
  const StepGoal near = step_goal(trials.goal().effort);
  const double most = trials.coder().most_anchors();
  for (const double factor : {kAnchorFactor, 1 / kAnchorFactor}) {
    Attempt from = start;
    for (;;) {
      HighpassSettings settings = from.settings;
      const auto count = static_cast<std::uint32_t>(std::min(settings.anchors * factor + 0.5, most));
      settings.anchors = std::max(count, trials.coder().fewest_anchors());
      if (settings.anchors == from.settings.anchors) break;
      DELTAMESH_TRY(const Attempt probe, trials.run(settings));
      const double load = trials.bounds().load(probe.figures.quality);
      if (load > kHopelessPositionalLoad) break;
      settings.step *= near.aim / load;
      DELTAMESH_TRY(const std::uint64_t bytes, trials.coder().bytes(settings));
      if (static_cast<double>(bytes) > kGuessShare * static_cast<double>(from.figures.bytes)) break;
      DELTAMESH_TRY(Attempt next, search_step(trials, settings, Watch::kAll, near));
      if (trials.bounds().load(next.figures.quality) > 1 || next.figures.bytes >= from.figures.bytes) break;
      from = std::move(next);
    }
  }
  return {};
}

/// Where the best stream leaves room in the positional bounds: less diffusion at its anchors if VDE binds,
/// else fewer anchors (all symbols are 0 then).
Result<void> use_up_room(Trials& trials) {
  const RateGoal& goal = trials.goal();
  const Attempt best = *trials.best();
  if (positional_load(trials, best) >= Trials::kLandedLoad) return {};
  if (!goal.bounds.vde) {
    DELTAMESH_TRY([[maybe_unused]] const Attempt thinned, thin_anchors(best, trials));
    return {};
  }
  HighpassSettings settings = best.settings;
  settings.diffusion = 0;
  settings.step = step_from_vde(trials.coder(), settings, *goal.bounds.vde);
  DELTAMESH_TRY(const Attempt plain, search_step(trials, settings, Watch::kVisual, step_goal(goal.effort)));
  if (positional_load(trials, plain) <= 1) return {};
  DELTAMESH_TRY([[maybe_unused]] const Attempt relaxed, raise_diffusion(plain, true, trials));
  return {};
}

/// The step follows the positional bound, at the diffusion in `settings`.
Result<void> follow_with_step(const HighpassSettings& settings, Trials& trials) {
  const RateGoal& goal = trials.goal();
  if (goal.bounds.max_error) return control_peaks(settings, trials);
  DELTAMESH_TRY(const Attempt landed, search_step(trials, settings, Watch::kAll, step_goal(goal.effort)));
  if (trials.bounds().load(landed.figures.quality) > 1 || goal.effort < kSearchEffort || goal.anchors)
    return {};
  if (goal.loses(landed.figures.bytes, kPositionalRivalShare)) return {};
  DELTAMESH_CHECK(explore_anchor_counts(landed, trials));
  return use_up_room(trials);
}

/// The first guess of a step for a positional bound alone: with diffusion LFE is some 3 VDE, and the largest
/// error some 4 LFE.
double guess_step(const Bounds& bounds, const HighpassSettings& settings, TrialCoder& coder) {
  double lfe = coder.longest_side();
  if (bounds.lfe) lfe = std::min(lfe, *bounds.lfe);
  if (bounds.max_error) lfe = std::min(lfe, *bounds.max_error / 4);
  return step_from_vde(coder, settings, lfe / 3);
}

/// The step is what it is: more anchors, then anchors where the error is largest.
Result<void> follow_with_anchors(HighpassSettings settings, Trials& trials) {
  const double most = trials.coder().most_anchors();
  for (;;) {
    DELTAMESH_TRY(const Attempt attempt, trials.run(settings));
    const double load = positional_load(trials, attempt);
    if (load <= 1 || trials.goal().anchors) return {};
    if (load < 1.5) {
      DELTAMESH_TRY([[maybe_unused]] const Attempt refined, refine_greedily(attempt, 0, trials));
      if (trials.best()) return {};
    }
    if (settings.anchors >= most) return {};
    settings.anchors = static_cast<std::uint32_t>(std::min(settings.anchors * 2.0, most));
  }
}

}  // namespace

Result<void> control_positions(HighpassSettings settings, Trials& trials) {
  const RateGoal& goal = trials.goal();
  TrialCoder& coder = trials.coder();
  const StepGoal near = step_goal(goal.effort);
  if (!goal.step) settings.step = coder.longest_side() / 1024;
  if (!goal.step && !goal.bounds.vde) {
    settings.diffusion = 1;
    if (goal.effort >= kFrugalEffort) settings.rate_weight = kDiffusedRateWeight;
    settings.centroids = false;  // they lower VDE, but LFE rises by as much at low rates
    settings.step = guess_step(goal.bounds, settings, coder);
    return follow_with_step(settings, trials);
  }

  if (!goal.step && goal.effort <= kOnePassEffort) {  // whichever binds, the step follows it
    settings.diffusion = 1;
    const double for_positions = guess_step(goal.bounds, settings, coder);
    settings.step = std::min(for_positions, step_from_vde(coder, settings, near.aim * *goal.bounds.vde));
    DELTAMESH_CHECK(check_rival(settings, trials));
    return follow_with_step(settings, trials);
  }

  Attempt plain;  // without diffusion, at the step that is fixed or that VDE sets
  if (goal.step) {
    DELTAMESH_TRY(plain, trials.run(settings));
  } else {
    settings = settings_for_vde(coder, settings, near.aim * *goal.bounds.vde, goal.effort);
    DELTAMESH_CHECK(check_rival(settings, trials));
    DELTAMESH_TRY(plain, search_step(trials, settings, Watch::kVisual, near));
    if (trials.bounds().visual_load(plain.figures.quality) > 1) return {};  // out of reach
  }
  double load = positional_load(trials, plain);
  if (load < Trials::kLandedLoad && goal.effort > kOnePassEffort && !goal.anchors) {
    DELTAMESH_TRY(plain, thin_anchors(plain, trials));
    load = positional_load(trials, plain);
  }
  if (load <= 1) return {};
  DELTAMESH_TRY(const Attempt diffused, raise_diffusion(plain, !goal.step.has_value(), trials));
  if (trials.bounds().load(diffused.figures.quality) <= 1) return {};
  return goal.step ? follow_with_anchors(diffused.settings, trials)
                   : follow_with_step(diffused.settings, trials);
}

}  // namespace deltamesh
