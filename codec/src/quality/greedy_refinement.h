// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Anchors where the error is largest (Yang, Li et al., section 4).
#pragma once

#include <cstdint>

#include "quality/step_search.h"

namespace deltamesh {

/// From `start`, which breaks a positional bound: vertices with the largest error
/// become anchors, in batches between runs, until the bounds are kept (the tolerance being what the bounds
/// leave), 12 runs are made, or the stream is larger than `most_bytes` (0: no limit). Returns the last run.
Result<Attempt> refine_greedily(const Attempt& start, std::uint64_t most_bytes, Trials& trials);

}  // namespace deltamesh
