// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Rows of a coarse level as cycles read them best: by fours.
#pragma once

#include "laplacian/settling/level.h"

namespace deltamesh::settling {

/// Fills both halves of every row, the edges to lower nodes and those to higher ones, with edges of weight 0
/// to the half's last node until their number is a multiple of kEdgesAtOnce: then hardly a branch in a sum
/// over neighbours is not foreseen. So nothing is read that was not before: 0 times what an earlier cycle
/// left, which may be infinite, need not be 0. Not for the finest level. O(n + edges).
void pad_rows(Level& level);

}  // namespace deltamesh::settling
