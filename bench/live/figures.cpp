// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "live/figures.h"

#include <algorithm>

namespace deltamesh::bench {

Figures figures_of(const std::vector<LiveResult>& results, const LiveResult& whole) {
  Figures sums;
  const auto count = static_cast<double>(results.size());
  for (const LiveResult& result : results) {
    for (const double time : freezes(result, whole)) {
      sums.longest = std::max(sums.longest, time);
      sums.frozen += time > kLongFreeze ? time / result.seconds / count : 0;
    }
    for (const LiveSample& sample : result.samples) sums.oldest = std::max(sums.oldest, sample.age);
    sums.bytes += static_cast<double>(result.bytes) / count;
    sums.bytes_back += static_cast<double>(result.bytes_back) / count;
    sums.settled = result.settled < 0 || sums.settled < 0 ? -1 : std::max(sums.settled, result.settled);
  }
  return sums;
}

}  // namespace deltamesh::bench
