// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How strong error diffusion must be.
#pragma once

#include "quality/step_search.h"

namespace deltamesh {

/// From `plain`, which keeps VDE without diffusion but not the positional bounds, looks for the strength at
/// which they are just kept; `step_moves` says whether the step is made up for what diffusion adds to VDE. At
/// most 6 runs. Returns the attempt that keeps all bounds, else that of full strength.
Result<Attempt> raise_diffusion(const Attempt& plain, bool step_moves, Trials& trials);

}  // namespace deltamesh
