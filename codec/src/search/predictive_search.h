// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The coarsest lattice or voxels that keep bounds on the error, and the finest that fit a number of bytes.
#pragma once

#include <cstdint>

#include "search/predictive_trials.h"

namespace deltamesh {

/// The smallest stream found that keeps `bounds`, at least one of which is set; there always is one. At
/// effort 0 the first lattice that does.
CodedGeometry keep_bounds(const Bounds& bounds, const PredictiveTrials& trials);

/// Whether keep_bounds() is likely to find a smaller stream than highpass coding, from statistics of the
/// mesh.
bool suits_predictive(const Bounds& bounds, const PredictiveTrials& trials);

/// The best stream found that is not longer. Errors: kUnmetRequest.
Result<CodedGeometry> fit_bytes(std::uint64_t bytes, const PredictiveTrials& trials);

}  // namespace deltamesh
