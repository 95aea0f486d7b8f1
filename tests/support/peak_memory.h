// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How much memory a test's process has had at once.
#pragma once

#include <sys/resource.h>

namespace deltamesh::test {

/// Kilobytes.
inline long peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

}  // namespace deltamesh::test
