// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The best quality that fits a number of bytes.
#pragma once

#include <cstdint>

#include "search/step_search.h"

namespace deltamesh {

/// Bisects on the step, with a guess from the last sizes, and keeps the stream of lowest VDE that has at most
/// `target` bytes. At most 10 codings for each rate weight tried, one run. Errors: kUnmetRequest where
/// not even the coarsest stream fits.
Result<void> fit_bytes(std::uint64_t target, const HighpassSettings& settings, Trials& trials);

}  // namespace deltamesh
