// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Fewer anchors, for a low-frequency error that is smaller than asked.
#pragma once

#include "quality/step_search.h"

namespace deltamesh {

/// From `start`, which keeps all bounds with room in the positional ones, takes anchors away: a second (v, M)
/// pair is measured at a quarter of the anchors, and the fitting function (quality/lfe_fit.h) gives the
/// container Delta_v for the request, twice at most; then the count is bisected inside the bracket found. At
/// most 8 runs. Returns the attempt that comes nearest to the bounds from below; or, where even that leaves
/// much room, the one with the next smaller count, which breaks them a little, for diffusion to mend.
Result<Attempt> thin_anchors(const Attempt& start, Trials& trials);

}  // namespace deltamesh
