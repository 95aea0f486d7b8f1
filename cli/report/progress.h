// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A sign of life for work that takes longer than a moment.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <thread>

namespace deltamesh::cli {

/// Draws on stderr from the second second on, and only where that is a terminal: the seconds so far and, once
/// the work has told its share, a bar. The line is gone when the object is.
class Progress {
 public:
  explicit Progress(std::string label);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// For the library's `progress` members; this object must outlive it.
  std::function<void(double)> callback();

 private:
  void draw_until(const std::stop_token& stop);

  std::string label_;
  std::atomic<double> share_{-1};  ///< 0 to 1; below 0: the work has not said
  std::jthread painter_;           ///< last, so that it ends before what it reads
};

}  // namespace deltamesh::cli
