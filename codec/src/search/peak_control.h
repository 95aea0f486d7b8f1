// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A maximum error, kept by anchors at the few vertices that a step leaves too far off; and anchors where the
// error is largest, for any positional bound (Yang, Li et al., section 4).
#pragma once

#include <cstdint>

#include "search/step_search.h"

namespace deltamesh {

/// Keeps every bound of the goal, of which one is a maximum error, from `settings`, whose step is a guess.
/// The largest error of a mesh is a matter of chance: it jumps from one step to the next, and a step that
/// keeps all vertices within the bound is needlessly small for nearly all of them, while an anchor costs as
/// much as a thousandth of a step for thousands of vertices. So the step grows beyond where the bound is
/// broken, and greedy refinement mends what sticks out, as long as the stream shrinks. Then the same with
/// fewer of the even anchors. At most some 40 runs, a few below effort 3. Where the bounds are kept nowhere,
/// trials.best() stays empty.
Result<void> control_peaks(const HighpassSettings& settings, Trials& trials);

/// Improves `start`, which breaks a positional bound: makes the vertices with the largest errors anchors, in
/// batches between runs, until the bounds are kept, 12 runs are made, or the stream is larger than
/// `most_bytes` (0: no limit). Returns the last run.
Result<Attempt> refine_greedily(const Attempt& start, std::uint64_t most_bytes, Trials& trials);

}  // namespace deltamesh
