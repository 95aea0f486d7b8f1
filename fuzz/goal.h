// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What every fuzz target demands: no internal errors, and goals that its seeds must reach, so that it is
// noticed when they grow stale.
#pragma once

#include <cstdlib>

#include "deltamesh/result.h"

namespace deltamesh::fuzz {

/// Whether there is a value; an internal error in its place stops the program.
template <class T>
bool check(const Result<T>& result) {
  if (!result && result.error().code == ErrorCode::kInternal) std::abort();
  return result.has_value();
}

/// A global of a target: a place behind all checks of one kind of input. Where the environment has
/// DELTAMESH_FUZZ_REPLAY, as in the tests fuzz_replay_*, the program fails at its end if no input reached it.
class Goal {
 public:
  /// `what`: the input, for the message; a literal.
  explicit Goal(const char* what) noexcept;
  void reach() noexcept { reached_ = true; }

  Goal(const Goal&) = delete;
  Goal& operator=(const Goal&) = delete;

 private:
  static void check_all() noexcept;

  const char* what_;
  const Goal* next_;
  bool reached_ = false;
};

}  // namespace deltamesh::fuzz
