// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "goal.h"

#include <cstdio>
#include <cstdlib>

namespace deltamesh::fuzz {
namespace {

constexpr const char* kReplay = "DELTAMESH_FUZZ_REPLAY";  ///< has the target's name

const Goal* last_goal = nullptr;

}  // namespace

Goal::Goal(const char* what) noexcept : what_(what), next_(last_goal) {
  if (last_goal == nullptr && std::getenv(kReplay) != nullptr) std::atexit(check_all);
  last_goal = this;
}

void Goal::check_all() noexcept {
  bool is_missed = false;
  for (const Goal* goal = last_goal; goal != nullptr; goal = goal->next_) {
    if (goal->reached_) continue;
    std::fprintf(stderr, "no seed in fuzz/corpus/%s is accepted as: %s\n", std::getenv(kReplay), goal->what_);
    is_missed = true;
  }
  // libFuzzer returns 0 where nothing crashed.
  if (is_missed) std::_Exit(EXIT_FAILURE);
}

}  // namespace deltamesh::fuzz
