// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From the quality that is asked for to the settings of the coder (Yang, Li et al., sections 3.3 and 4).
#pragma once

#include "search/rate_goal.h"
#include "search/trial.h"

namespace deltamesh {

/// Drives `coder` until every bound is kept, and returns the smallest stream it found that does so.
/// Deterministic. Runs: one without bounds and target, 1 to 3 for a VDE or at effort 0, some 10 to 20 for
/// several bounds at effort 5.
/// Errors: kUnmetRequest with the best figure that can be had and the size of that stream, or where the rival
/// wins; those of `coder`, where kInvalidStream only if no settings tried make a stream that decodes.
Result<Attempt> control_rate(const RateGoal& goal, TrialCoder& coder);

}  // namespace deltamesh
