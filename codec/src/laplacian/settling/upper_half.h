// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The graph of a coarse level in the making: every edge once.
#pragma once

#include "base/large_vector.h"
#include "laplacian/settling/level.h"
#include "laplacian/settling/sparse_rows.h"

namespace deltamesh::settling {

/// Positive entries right of the diagonal, row by row, and the largest of every whole row.
struct UpperHalf {
  SparseRows rows;
  LargeVector<float> largest;
};

/// The graph and the degrees of `coarse` from all entries but those below `smallest` times the lesser of the
/// largest entries of their two rows. O(nodes + entries).
void make_graph(UpperHalf upper, float smallest, Level& coarse);

/// `degree` and `inverse_degree` of a level whose edges have weights.
void set_degrees(Level& level);

}  // namespace deltamesh::settling
