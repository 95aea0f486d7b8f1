// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What the display of a receiver has been like, from the records of runs.
#pragma once

#include <vector>

#include "live/run.h"

namespace deltamesh::bench {

inline constexpr double kLongFreeze = 1;  // seconds

/// Of runs that differ in their random numbers alone.
struct Figures {
  double longest = 0;     ///< of all freezes, seconds
  double frozen = 0;      ///< share of the time in freezes above kLongFreeze
  double oldest = 0;      ///< largest age of a part that is shown, seconds
  double bytes = 0;       ///< mean
  double bytes_back = 0;  ///< mean
  double settled = 0;     ///< longest; negative: one has not
};

/// `whole`: a run of the same updates over a link that loses nothing.
Figures figures_of(const std::vector<LiveResult>& results, const LiveResult& whole);

}  // namespace deltamesh::bench
