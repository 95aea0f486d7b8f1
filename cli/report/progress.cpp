// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "report/progress.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <system_error>
#include <utility>

namespace deltamesh::cli {
namespace {

constexpr int kWidth = 40;
constexpr std::chrono::seconds kPatience{1};
constexpr std::chrono::milliseconds kRedraw{100};

void draw(const std::string& label, double share, int seconds) {
  if (share < 0) {
    std::fprintf(stderr, "\r%s %d s\x1b[K", label.c_str(), seconds);
    return;
  }
  const double part = std::min(share, 1.0);
  const auto filled = static_cast<std::size_t>(part * kWidth);
  const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
  std::fprintf(stderr, "\r%s [%s] %3.0f %% %d s\x1b[K", label.c_str(), bar.c_str(), 100 * part, seconds);
}

}  // namespace

Progress::Progress(std::string label) : label_(std::move(label)) {
  if (isatty(STDERR_FILENO) != 1) return;
  try {
    painter_ = std::jthread([this](std::stop_token stop) { draw_until(stop); });
  } catch (const std::system_error&) {
    // No thread to be had: nothing is drawn, then.
  }
}

std::function<void(double)> Progress::callback() {
  return [this](double share) { share_ = share; };
}

void Progress::draw_until(const std::stop_token& stop) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any stopped;
  const auto never = [] { return false; };
  bool drawn = false;
  for (std::chrono::milliseconds wait = kPatience;; wait = kRedraw) {
    stopped.wait_for(lock, stop, wait, never);
    if (stop.stop_requested()) break;
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - start);
    draw(label_, share_, static_cast<int>(seconds.count()));
    drawn = true;
  }
  if (drawn) std::fputs("\r\x1b[K", stderr);
}

}  // namespace deltamesh::cli
