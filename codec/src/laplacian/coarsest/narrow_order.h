// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// An order of nodes in which neighbours are near each other, for factors of narrow rows [Cuthill and McKee
// 1969, reversed as by George 1971].
#pragma once

#include <cstdint>
#include <vector>

#include "laplacian/multigrid/level/level.h"

namespace deltamesh::multigrid {

/// The nodes, `nodes`: overwritten, in the reverse of a breadth-first order that begins at an end of the
/// graph. O(n + edges).
void order_narrowly(const Level& level, std::vector<std::uint32_t>& nodes);

}  // namespace deltamesh::multigrid
