// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What the caller is told of the work done.
#pragma once

#include <algorithm>
#include <functional>

#include "base/guard.h"

namespace deltamesh {

/// Shares of the whole time, which never fall.
class Progress {
 public:
  /// `callback` may be empty; it must outlive this.
  explicit Progress(const std::function<void(double)>& callback) noexcept : callback_(callback) {}

  /// All stages up to here are done; those until the next call end at `next` at the latest.
  void reach(double share, double next) {
    end_ = next;
    tell(std::max(share_, share));
  }
  /// One more trial is done, of nobody knows how many: the way to the end of the stage gets shorter.
  void tick() { tell(share_ + kTick * (end_ - share_)); }

 private:
  static constexpr double kTick = 0.08;

  void tell(double share) {
    share_ = share;
    if (callback_) call_back(callback_, share);
  }

  const std::function<void(double)>& callback_;
  double share_ = 0;
  double end_ = 0;
};

}  // namespace deltamesh
