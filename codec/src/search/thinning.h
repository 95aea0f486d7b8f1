// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Fewer anchors, for a low-frequency error that is smaller than asked.
#pragma once

#include "search/step_search.h"

namespace deltamesh {

/// Removes anchors from `start`, which keeps all bounds with room in the positional ones. A second (v, M)
/// pair is measured at a quarter of the anchors, and the fitting function (quality/lfe_fit.h) gives the
/// container Delta_v for the request, at most twice; then the count is bisected inside the bracket found. At
/// most 8 runs. Returns the attempt nearest to the bounds that keeps them; if that leaves much room, the one
/// with the next smaller count, which breaks them slightly, so that diffusion can correct it.
Result<Attempt> thin_anchors(const Attempt& start, Trials& trials);

}  // namespace deltamesh
