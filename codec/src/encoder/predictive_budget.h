// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The finest lattice or voxels that fit a number of bytes.
#pragma once

#include <cstdint>

#include "encoder/predictive_trials.h"

namespace deltamesh {

/// The best stream found that is not longer. Errors: kUnmetRequest.
Result<CodedGeometry> fit_bytes(std::uint64_t bytes, const PredictiveTrials& trials);

}  // namespace deltamesh
