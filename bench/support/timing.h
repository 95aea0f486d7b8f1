// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The timing of all benchmarks: runs in turn, so that whatever else the machine does disturbs all alike.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <ctime>
#include <limits>
#include <utility>
#include <vector>

#include "deltamesh/result.h"

namespace deltamesh::bench {

/// Processor time of this process since it began, which other programs disturb least.
inline double processor_seconds() noexcept { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

/// Median of the ratios that each round has, whose two times share what else went on.
inline double median_ratio(std::vector<double> ours, const std::vector<double>& theirs) {
  for (std::size_t r = 0; r < ours.size(); ++r) ours[r] /= theirs[r];
  return median(std::move(ours));
}

/// How long to time.
struct TimingEffort {
  int rounds = 1;                                            ///< most of them
  double seconds = std::numeric_limits<double>::infinity();  ///< no new round after so many, all together
  double least_seconds = 0;  ///< of one figure: the mean of as many runs as take that, at most 50
};

/// Mean processor seconds of a run of `work`, which returns a Result or nothing. Errors: of the runs.
template <class Work>
Result<double> seconds_of(Work& work, double least_seconds = 0) {
  constexpr int kMostRuns = 50;
  const double start = processor_seconds();
  for (int runs = 1;; ++runs) {
    if (const auto done = work(); !done) return done.error();
    const double passed = processor_seconds() - start;
    if (passed >= least_seconds || runs == kMostRuns) return std::max(passed, 1e-7) / runs;
  }
}

/// Runs each of `works` once a round: the seconds of each, by rounds. Errors: of the first run that fails.
template <class... Work>
Result<std::array<std::vector<double>, sizeof...(Work)>> time_in_turn(const TimingEffort& effort,
                                                                      Work&&... works) {
  std::array<std::vector<double>, sizeof...(Work)> times;
  double total = 0;
  for (int round = 0; round == 0 || (round < effort.rounds && total < effort.seconds); ++round) {
    const Result<double> passed[] = {seconds_of(works, effort.least_seconds)...};
    for (std::size_t i = 0; i < times.size(); ++i) {
      if (!passed[i]) return passed[i].error();
      times[i].push_back(*passed[i]);
      total += *passed[i];
    }
  }
  return times;
}

}  // namespace deltamesh::bench
