// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From a request to the settings of the highpass coder (Yang, Li et al., sections 3.3 and 4): VDE sets the
// step, LFE and the largest error set anchors and diffusion; without VDE they set the step.
#pragma once

#include <cstdint>
#include <limits>

#include "search/highpass_trials.h"
#include "search/request.h"

namespace deltamesh {

/// The smallest candidate found that keeps `request`. Deterministic. Candidates made: one for a fixed step or
/// a budget; 1 to 4 for a VDE; some 10 for positional bounds, a few at effort 0. Errors: kUnmetRequest with
/// the best that can be had; those of `trials`, where kInvalidStream only if no settings tried make a stream
/// that decodes. `most_bytes`: a search for bounds ends with a candidate of so many while none keeps them.
Result<Candidate> search_highpass(const Request& request, HighpassTrials& trials,
                                  std::uint64_t most_bytes = std::numeric_limits<std::uint64_t>::max());

/// Bytes, without a solve, of a stream whose VDE is about `vde`: what the search would find within a few per
/// cent.
Result<std::uint64_t> forecast_highpass_bytes(const Request& request, double vde, HighpassTrials& trials);

}  // namespace deltamesh
