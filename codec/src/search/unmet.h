// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Errors for requests that cannot be met.
#pragma once

#include "search/step_search.h"

namespace deltamesh {

/// Nothing where `trials` has a stream that keeps everything asked. Otherwise kUnmetRequest with the figure
/// that the nearest stream has where it breaks a bound most, and its size; or, where no stream decodes, why
/// not. Precondition: something has been run.
Result<void> check_met(const Trials& trials) noexcept;

/// `bytes`: of the smallest stream there can be.
Error too_few_bytes(std::uint64_t bytes) noexcept;

/// Before anything is solved: kUnmetRequest where `settings`, a guess, would make a stream that loses to the
/// rival's: at all at effort 0 and 1, by more than what a search may save from then on. A coding's cost.
Result<void> check_rival(const HighpassSettings& settings, Trials& trials);

}  // namespace deltamesh
