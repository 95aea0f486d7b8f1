// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Time that never goes back, from a clock that may be set.
#pragma once

#include <algorithm>
#include <cmath>

namespace deltamesh {

class SteadyTime {
 public:
  /// Seconds. Where the clock goes back, none pass; 2 at the most from call to call. What is not finite is
  /// no time.
  double at(double now) noexcept {
    if (!std::isfinite(now)) return time_;
    offset_ -= std::max(now + offset_ - time_ - kMostStep, 0.0);
    const double time = now + offset_;
    if (time >= time_) return time_ = time;
    // Callers with several clocks are a little apart; what is more is a clock that was set.
    if (time_ - time > kApart) offset_ = time_ - now;
    return time_;
  }

 private:
  static constexpr double kApart = 1;  // seconds
  static constexpr double kMostStep = 2;
  double offset_ = 0;
  double time_ = 0;
};

}  // namespace deltamesh
