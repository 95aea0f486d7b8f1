// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// VDE sets the step (Yang, Li et al., section 3.3; Table 1: one more bit halves it).
#pragma once

#include "search/step_search.h"

namespace deltamesh {

/// The step at which VDE will be about `vde`, without a run: VDE is 0.76 of the delta error within a few per
/// cent on every mesh and at every rate, which is 0.38 of the step (Table 1) where the step is small.
double step_from_vde(TrialCoder& coder, const HighpassSettings& settings, double vde);

/// How near a search comes at this effort.
StepGoal step_goal(int effort) noexcept;

/// HighpassSettings::rate_weight where symbols are chosen by rate, from kFrugalEffort on: best within 0.5 %
/// on all meshes from 3 to 6 bits; and under diffusion, for a positional bound alone.
inline constexpr double kRateWeight = 0.12;
inline constexpr double kDiffusedRateWeight = 0.08;
inline constexpr int kFrugalEffort = 3;

/// A step for this VDE; symbols are chosen by rate too, which saves 1 to 7 % of the deltas' bytes below 7
/// bits.
HighpassSettings settings_for_vde(TrialCoder& coder, HighpassSettings settings, double vde, int effort);

/// Keeps VDE alone; no diffusion.
Result<void> control_visual(HighpassSettings settings, Trials& trials);

}  // namespace deltamesh
