// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Between a level and the next coarser one: interpolation P upward, its transpose downward.
#pragma once

#include <span>

#include "laplacian/settling/level.h"
#include "laplacian/settling/row.h"

namespace deltamesh::settling {

/// coarse = P^T fine. O(n).
void restrict_rows(const Level& level, std::span<const Row> fine, std::span<Row> coarse);

/// fine = P coarse. O(n).
void prolong_rows(const Level& level, std::span<const Row> coarse, std::span<Row> fine);

/// fine += P coarse. O(n).
void add_prolonged_rows(const Level& level, std::span<const Row> coarse, std::span<Row> fine);

}  // namespace deltamesh::settling
