// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// An order of a sparse matrix's rows in which its factor stays sparse.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace deltamesh::settling {

/// Nested dissection: the middle level of a breadth-first search separates a component's rows into two halves
/// and comes after both, and so on in each half. `offsets` (n + 1) and `columns`: of each row the others with
/// which it shares an entry. Returns every row's place. O(entries log n). Source: George, Liu, Computer
/// Solution of Large Sparse Positive Definite Systems, 1981, chapter 8.
std::vector<std::uint32_t> dissect(std::span<const std::uint32_t> offsets,
                                   std::span<const std::uint32_t> columns);

}  // namespace deltamesh::settling
