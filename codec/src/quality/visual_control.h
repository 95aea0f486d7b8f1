// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// VDE sets the step (Yang, Li et al., section 3.3; Table 1: one more bit halves it).
#pragma once

#include "quality/rate_control.h"
#include "quality/step_search.h"

namespace deltamesh {

/// The step at which VDE will be about `vde`, without a run: VDE is 0.76 of the delta error within a few per
/// cent on every mesh and at every rate, which is 0.38 of the step (Table 1) where the step is small.
double step_from_vde(TrialCoder& coder, const CoderSettings& settings, double vde);

/// How near a search comes at this effort.
StepGoal step_goal(int effort) noexcept;

/// The rounding with which a stream of this VDE is smallest; settings.step is set for it. Below some 2 bits
/// per coordinate symbols that tend to zero save more than the finer step costs. A few codings' cost, no run.
Result<CoderSettings> choose_rounding(TrialCoder& coder, CoderSettings settings, double vde, int effort);

/// Keeps VDE alone; no diffusion.
Result<void> control_visual(const RateGoal& goal, CoderSettings settings, Trials& trials);

}  // namespace deltamesh
