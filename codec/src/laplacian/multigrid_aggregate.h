// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which nodes of a level live on in the next coarser one, and which of those every other node belongs to.
#pragma once

#include <cstdint>
#include <vector>

#include "laplacian/multigrid_level.h"

namespace deltamesh::multigrid {

struct Aggregates {
  std::vector<std::uint32_t> of;     ///< n: aggregate of every node
  std::vector<std::uint32_t> seeds;  ///< the node that each aggregate grew from, ascending
};

/// Seeds are all anchors and hubs, then, in order, every node without a seed other than a hub among its
/// neighbours. Any other node joins that of these seeds whose aggregate is smallest so far, the first among
/// equals. Hubs stay alone. O(n + edges).
Aggregates aggregate(const Level& fine);

}  // namespace deltamesh::multigrid
