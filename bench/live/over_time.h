// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What receivers have over time, as a table and as plots.
#pragma once

#include <string>
#include <vector>

#include "live/run.h"

namespace deltamesh::bench {

class OverTime {
 public:
  void add(const std::string& sequence, const LiveSettings& settings, const LiveResult& result);

  /// over_time.csv, and SEQUENCE.ROUND_TRIPms.{age,error,bytes}.svg of the runs with the first random
  /// numbers, six at most in each. False, and a line on stderr, where it cannot.
  bool write(const std::string& folder) const;

 private:
  struct Run {
    std::string sequence;
    LiveSettings settings;
    std::vector<LiveSample> samples;
  };

  bool write_plots(const std::string& folder, const Run& first) const;

  std::vector<Run> runs_;
};

}  // namespace deltamesh::bench
