// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which nodes of a level become nodes of the next coarser one, and which of those every other node belongs
// to.
#pragma once

#include <cstdint>
#include <span>

#include "base/memory/large_vector.h"
#include "laplacian/multigrid/level/level.h"

namespace deltamesh::multigrid {

struct Aggregates {
  LargeVector<std::uint32_t> codes;  ///< n: a node's aggregate, plus kSeed for the seed; kNone without edges
  LargeVector<std::uint32_t> members;  ///< of one aggregate after the other, the seed first
  LargeVector<std::uint32_t> start;    ///< count() + 1: in `members`

  static constexpr std::uint32_t kSeed = std::uint32_t{1} << 31;
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  /// Numbered as their seeds are.
  std::uint32_t count() const noexcept { return static_cast<std::uint32_t>(start.size() - 1); }
  std::uint32_t of(std::uint32_t node) const noexcept { return codes[node] & ~kSeed; }
  std::span<const std::uint32_t> members_of(std::uint32_t aggregate) const noexcept {
    return {members.data() + start[aggregate], members.data() + start[aggregate + 1]};
  }
};

/// Seeds are all anchors and then, by number, every node without a seed among its neighbours; any other node
/// belongs to the lowest seed among its neighbours [DELT-7]. Nodes without edges belong to none, anchors or
/// not. O(n + edges).
Aggregates aggregate(const Level& fine);

}  // namespace deltamesh::multigrid
