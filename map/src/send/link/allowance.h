// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How many bytes a receiver may get now.
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <limits>
#include <utility>

namespace deltamesh {

/// In any second at most as many bytes as the rate says, plus one message; what that has too many is made up
/// for later.
class Allowance {
 public:
  /// Counts the time up to `now`, seconds. `rate`: bytes per second; 0: no limit. `most`: bytes until the
  /// next time.
  void begin(double rate, double now, double most = std::numeric_limits<double>::infinity()) {
    most_ = most;
    const double passed = has_begun_ ? std::max(now - now_, 0.0) : 1;
    has_begun_ = true;
    now_ = now;
    rate_ = rate;
    saved_ = std::min(saved_ + rate_ * passed, rate_);
    while (!spent_.empty() && spent_.front().first <= now - 1) {
      in_a_second_ -= spent_.front().second;
      spent_.pop_front();
    }
  }

  /// Not more than this until the next time.
  void limit(double most) noexcept { most_ = std::min(most_, most); }

  /// How many bytes may be sent now; a message that begins below it may be longer.
  double room() const noexcept {
    return rate_ == 0 ? most_ : std::min({saved_, rate_ - in_a_second_, most_});
  }
  bool may_spend() const noexcept { return room() > 0; }

  void spend(std::size_t bytes) {
    const auto size = static_cast<double>(bytes);
    most_ -= size;
    if (rate_ == 0) return;
    saved_ -= size;
    in_a_second_ += size;
    spent_.emplace_back(now_, size);
  }

 private:
  std::deque<std::pair<double, double>> spent_;  ///< in the last second: when, and how many bytes
  double in_a_second_ = 0;                       ///< their sum
  double saved_ = 0;                             ///< bytes; below 0: debts
  double rate_ = 0;
  double most_ = std::numeric_limits<double>::infinity();
  double now_ = 0;
  bool has_begun_ = false;
};

}  // namespace deltamesh
