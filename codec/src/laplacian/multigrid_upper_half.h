// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The graph of a coarse level in the making: every edge once.
#pragma once

#include <cstdint>

#include "base/large_vector.h"
#include "laplacian/multigrid_level.h"

namespace deltamesh::multigrid {

/// An entry of a sparse matrix, in the row that it is listed for.
struct Entry {
  std::uint32_t node;
  float weight;
};

/// Positive entries right of the diagonal, row by row, and the largest of every whole row.
struct UpperHalf {
  LargeVector<std::uint32_t> start;
  LargeVector<Entry> entries;
  LargeVector<float> largest;
};

/// The graph and the degrees of `coarse` from all entries but those below `smallest` times the lesser of the
/// largest entries of their two rows. O(nodes + entries).
void make_graph(UpperHalf upper, float smallest, Level& coarse);

}  // namespace deltamesh::multigrid
