// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From a request to the lattice or the voxels of the predictive coder.
#pragma once

#include "search/predictive_trials.h"

namespace deltamesh {

/// The smallest candidate found that keeps the request, or the best that fits its bytes; for bounds alone
/// there always is one. At effort 0 the first one that keeps them. Errors: kUnmetRequest, kInvalidArgument.
Result<Candidate> search_predictive(const PredictiveTrials& trials);

/// A step of a lattice near which `bounds` are just kept.
double lattice_step_for(const Bounds& bounds, const Box& box) noexcept;

/// Whether most vertices are on edges of voxels that are not much finer than the bounds' lattice, and faces
/// no larger.
bool are_voxels_enough(const PredictiveTrials& trials);

}  // namespace deltamesh
