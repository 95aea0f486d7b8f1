// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The clock of all benchmarks that measure by turns.
#pragma once

#include <ctime>

namespace deltamesh::bench {

/// Of this process, since it began.
inline double processor_seconds() noexcept { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace deltamesh::bench
