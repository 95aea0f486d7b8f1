// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A progress bar for work that takes longer than a moment.
#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace deltamesh::cli {

/// Draws on stderr, and only where that is a terminal and the work has taken over a second. The bar is gone
/// when the object is.
class Progress {
 public:
  explicit Progress(std::string label);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// For the library's `progress` members; this object must outlive it.
  std::function<void(double)> callback();

 private:
  using Clock = std::chrono::steady_clock;
  void show(double share);

  std::string label_;
  bool terminal_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_{};
};

}  // namespace deltamesh::cli
