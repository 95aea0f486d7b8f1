// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which nodes of a level live on in the next coarser one, and which of those every other node belongs to.
#pragma once

#include <cstdint>
#include <vector>

#include "base/large_vector.h"
#include "laplacian/multigrid_level.h"

namespace deltamesh::multigrid {

struct Aggregates {
  LargeVector<std::uint32_t> codes;  ///< n: a node's aggregate, plus kSeed for the node that it grew from
  std::vector<std::uint32_t> seeds;  ///< of every aggregate, ascending

  static constexpr std::uint32_t kSeed = std::uint32_t{1} << 31;

  std::uint32_t of(std::uint32_t node) const noexcept { return codes[node] & ~kSeed; }
  bool is_seed(std::uint32_t node) const noexcept { return codes[node] >= kSeed; }
};

/// Seeds are all anchors and hubs, then, in order, every node without a seed other than a hub among its
/// neighbours. Any other node belongs to the first of these seeds. Hubs stay alone. O(n + edges).
Aggregates aggregate(const Level& fine);

}  // namespace deltamesh::multigrid
