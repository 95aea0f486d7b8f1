// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What goes wrong in peers, and the end of programs that it goes wrong in.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <utility>

#include "deltamesh/result.h"

namespace deltamesh::bench {

/// What a peer says that refuses a mesh or a stream.
inline Error failure(const char* message) noexcept {
  return {.code = ErrorCode::kInternal, .message = message};
}

/// Prints an error and exits: a benchmark of a failure says nothing.
template <class R>
void check_or_exit(const R& result) {
  if (result) return;
  std::fprintf(stderr, "%s\n", describe(result.error()).c_str());
  std::exit(EXIT_FAILURE);
}

/// The value of a result, or likewise.
template <class T>
T value_or_exit(Result<T> result) {
  check_or_exit(result);
  return *std::move(result);
}

}  // namespace deltamesh::bench
