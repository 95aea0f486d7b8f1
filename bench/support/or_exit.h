// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Returns the value of a result, or prints its error and exits: a benchmark of a failure says nothing.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <utility>

#include "deltamesh/result.h"

namespace deltamesh::bench {

template <class R>
void check_or_exit(const R& result) {
  if (result) return;
  std::fprintf(stderr, "%s\n", describe(result.error()).c_str());
  std::exit(EXIT_FAILURE);
}

template <class T>
T value_or_exit(Result<T> result) {
  check_or_exit(result);
  return *std::move(result);
}

}  // namespace deltamesh::bench
