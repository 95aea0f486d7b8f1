// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "quality/diffusion_search.h"

#include <algorithm>

#include "base/try.h"

namespace deltamesh {
namespace {

constexpr double kAim = 0.95;
constexpr double kWeak = 0.975;  // loads above ask for more strength, those below for less
constexpr int kMostRuns = 6;
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
  const double share = (weak.load - kAim) / (weak.load - strong.load);
  return weak.strength + std::clamp(share, 0.05, 0.95) * (strong.strength - weak.strength);
}

}  // namespace

Result<Attempt> raise_diffusion(const Attempt& plain, bool step_moves, Trials& trials) {
  if (!plain.decodes()) return plain;
  TrialCoder& coder = trials.coder();
  const Bounds& bounds = trials.bounds();
  const double delta_error = coder.delta_error(plain.settings);
  HighpassSettings settings = plain.settings;
  Point weak{settings.diffusion, bounds.positional_load(plain.figures.quality)};
  Point strong{1, kFullStrengthLoad * weak.load};
  settings.diffusion = strong.load < kAim ? strength_between(weak, strong) : 1;
  std::optional<Attempt> kept;
  double visual_share = 1;  // what the delta error may be, so that VDE comes near its bound
  for (int runs = 0; runs <= kMostRuns; ++runs) {
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

}  // namespace deltamesh
