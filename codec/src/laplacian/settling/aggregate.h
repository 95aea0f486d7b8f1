// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which nodes of a level live on in the next coarser one, and which of those every other node belongs to.
#pragma once

#include <cstdint>
#include <span>

#include "base/large_vector.h"
#include "laplacian/settling/level.h"

namespace deltamesh::settling {

struct Aggregates {
  LargeVector<std::uint32_t> codes;    ///< n: a node's aggregate, plus kSeed for the node that it grew from
  LargeVector<std::uint32_t> members;  ///< n: of one aggregate after the other, the seed first
  LargeVector<std::uint32_t> start;    ///< count() + 1: in `members`

  static constexpr std::uint32_t kSeed = std::uint32_t{1} << 31;

  /// Numbered as their seeds are.
  std::uint32_t count() const noexcept { return static_cast<std::uint32_t>(start.size() - 1); }
  std::uint32_t of(std::uint32_t node) const noexcept { return codes[node] & ~kSeed; }
  bool is_seed(std::uint32_t node) const noexcept { return codes[node] >= kSeed; }
  std::span<const std::uint32_t> members_of(std::uint32_t aggregate) const noexcept {
    return {members.data() + start[aggregate], members.data() + start[aggregate + 1]};
  }
};

/// Seeds are all anchors and hubs, then, in order, every node without a seed other than a hub among its
/// neighbours. Any other node belongs to the first of these seeds. Hubs stay alone. O(n + edges).
Aggregates aggregate(const Level& fine);

}  // namespace deltamesh::settling
