// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/rate_control.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/try.h"
#include "search/bounds.h"
#include "search/byte_budget.h"
#include "search/positional_control.h"
#include "search/step_search.h"
#include "search/trial.h"
#include "search/unmet.h"
#include "search/visual_control.h"

namespace deltamesh {
namespace {

// One anchor for so many vertices.
constexpr std::uint32_t kForVde = 500;
constexpr std::uint32_t kForLfe = 200;
constexpr std::uint32_t kForMaxError = 50;

// Largest side of a lattice cell against each bound. A vertex that is coded as an anchor is off by half a
// side in the root mean square and by 0.87 sides at most; solved vertices feel a small part of it.
constexpr double kCellPerLfe = 0.5;
constexpr double kCellPerMaxError = 0.6;
constexpr double kCellPerVde = 8;
constexpr double kCellPerVdeOfSmall = 0.8;

/// Bits per axis, `least` to 24, at which the anchors' own rounding uses up only a part of each bound.
int anchor_bits_for(const Bounds& bounds, int least, TrialCoder& coder) {
  double side = std::numeric_limits<double>::infinity();
  if (bounds.lfe) side = std::min(side, kCellPerLfe * *bounds.lfe);
  if (bounds.max_error) side = std::min(side, kCellPerMaxError * *bounds.max_error);
  if (bounds.vde)
    side = std::min(side, (coder.has_small_components() ? kCellPerVdeOfSmall : kCellPerVde) * *bounds.vde);
  int bits = least;
  while (bits < kMostAnchorBits && coder.longest_side() > side * (std::ldexp(1.0, bits) - 1)) ++bits;
  return bits;
}

/// At least one per component; and one for so many solved vertices:
/// - 500 where only VDE is asked for: with fewer, what is saved is under 0.1 bits per vertex;
/// - 200 for an LFE, 50 for a maximum error: near what is best on open maps.
std::uint32_t usual_anchors(const Bounds& bounds, TrialCoder& coder) {
  const std::uint32_t vertices = bounds.max_error ? kForMaxError : bounds.lfe ? kForLfe : kForVde;
  const std::uint32_t wanted = coder.most_anchors() / vertices + 1;
  return std::clamp(wanted, coder.fewest_anchors(), std::max(coder.fewest_anchors(), coder.most_anchors()));
}

}  // namespace

Result<Attempt> control_rate(const RateGoal& goal, TrialCoder& coder) {
  Trials trials(coder, goal);
  const bool bounded = goal.bounds.vde || goal.bounds.positional();
  HighpassSettings settings;
  settings.anchors = goal.anchors.value_or(usual_anchors(goal.bounds, coder));
  settings.anchor_bits = anchor_bits_for(goal.bounds, goal.anchor_bits, coder);
  settings.step = goal.step.value_or(1);
  settings.centroids = bounded || goal.target_bytes;
  if (!bounded && goal.target_bytes) {
    DELTAMESH_CHECK(fit_bytes(*goal.target_bytes, settings, trials));
  } else if (!bounded) {
    DELTAMESH_TRY([[maybe_unused]] const Attempt only, trials.run(settings));
  } else if (goal.bounds.positional()) {
    DELTAMESH_CHECK(control_positions(settings, trials));
  } else {
    DELTAMESH_CHECK(control_visual(settings, trials));
  }
  DELTAMESH_CHECK(check_met(trials));
  return *trials.best();
}

}  // namespace deltamesh
