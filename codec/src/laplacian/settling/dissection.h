// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// An order of a sparse matrix's rows in which its factor stays sparse.
#pragma once

#include <cstdint>
#include <vector>

#include "topology/adjacency.h"

namespace deltamesh::settling {

/// Nested dissection: the middle level of a breadth-first search separates a component's vertices into two
/// halves and comes after both, and so on in each half. Hubs come last. Returns every vertex's place.
/// O(edges log n). Source: George, Liu, Computer Solution of Large Sparse Positive Definite Systems, 1981,
/// chapter 8.
std::vector<std::uint32_t> dissect(const Adjacency& graph);

}  // namespace deltamesh::settling
