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

Result<void> control_rate(const RateGoal& goal, TrialCoder& coder) {
  Trials trials(coder, goal.bounds, goal.target_bytes);
  const bool bounded = goal.bounds.vde || goal.bounds.positional();
  CoderSettings settings;
  settings.anchors = goal.anchors.value_or(usual_anchors(goal.bounds, coder));
  settings.anchor_bits = anchor_bits_for(goal.bounds, goal.anchor_bits, coder);
  settings.step = goal.step.value_or(1);
  if (!bounded) {
    DELTAMESH_CHECK(fit_bytes(*goal.target_bytes, goal.effort, settings, trials));
  } else if (goal.bounds.positional()) {
    DELTAMESH_CHECK(control_positions(goal, settings, trials));
  } else {
    DELTAMESH_CHECK(control_visual(goal, settings, trials));
  }
  return check_met(goal, trials);
}

}  // namespace deltamesh
