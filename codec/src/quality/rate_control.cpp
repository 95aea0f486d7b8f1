// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "quality/rate_control.h"

#include <algorithm>

#include "base/try.h"
#include "quality/anchor_bits.h"
#include "quality/byte_budget.h"
#include "quality/positional_control.h"
#include "quality/step_search.h"
#include "quality/unmet.h"
#include "quality/visual_control.h"

namespace deltamesh {

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
