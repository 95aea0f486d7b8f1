// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// LFE and the maximum error set diffusion and anchors (Yang, Li et al., section 4, and error diffusion, which
// is ours).
#pragma once

#include "search/step_search.h"

namespace deltamesh {

/// Keeps every bound of the goal, of which at least one is positional; the step may be fixed.
/// - Step free, no VDE asked: full diffusion, the step follows the positional bound.
/// - Otherwise the step is fixed or follows VDE, and the positional error is steered without it: too small,
///   anchors are taken away along the containers by the fitting function (thin_anchors); too large, diffusion
///   is turned up (raise_diffusion); that not being enough, the step shrinks or anchors are added where the
///   error is largest (refine_greedily).
/// - From effort 5 other anchor counts are tried for a smaller stream.
Result<void> control_positions(HighpassSettings settings, Trials& trials);

}  // namespace deltamesh
