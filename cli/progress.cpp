// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace deltamesh::cli {
namespace {

constexpr int kWidth = 40;
constexpr std::chrono::seconds kPatience{1};
constexpr std::chrono::milliseconds kRedraw{100};

}  // namespace

Progress::Progress(std::string label) : label_(std::move(label)), terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (drawn_) std::fputs("\r\x1b[K", stderr);
}

std::function<void(double)> Progress::callback() {
  if (!terminal_) return {};
  return [this](double share) { show(share); };
}

void Progress::show(double share) {
  const Clock::time_point now = Clock::now();
  if (now - start_ < kPatience || now - last_ < kRedraw) return;
  last_ = now;
  drawn_ = true;
  const double part = std::clamp(share, 0.0, 1.0);
  const auto filled = static_cast<std::size_t>(part * kWidth);
  const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
  std::fprintf(stderr, "\r%s [%s] %3.0f %%\x1b[K", label_.c_str(), bar.c_str(), 100 * part);
}

}  // namespace deltamesh::cli
