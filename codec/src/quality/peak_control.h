// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A maximum error, kept by anchors at the few vertices that a step leaves too far off.
#pragma once

#include "quality/step_search.h"

namespace deltamesh {

/// Keeps every bound of the goal, of which one is a maximum error, from `settings`, whose step is a guess.
/// The largest error of a mesh is a matter of chance: it jumps from one step to the next, and a step that
/// keeps all vertices within the bound is needlessly small for nearly all of them, while an anchor costs as
/// much as a thousandth of a step for thousands of vertices. So the step grows beyond where the bound is
/// broken, and greedy refinement mends what sticks out, as long as the stream shrinks. Then the same with
/// fewer of the even anchors. At most some 40 runs, a few below effort 3. Where the bounds are kept nowhere,
/// trials.best() stays empty.
Result<void> control_peaks(const HighpassSettings& settings, Trials& trials);

}  // namespace deltamesh
