// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// An order of a coarsest level's nodes in which two threads can go through most of them.
#pragma once

#include <cstdint>
#include <vector>

#include "laplacian/settling/level.h"

namespace deltamesh::settling {

/// Two parts and the rest, which comes last: no node of one part is, or has for a neighbour, what a node of
/// the other is or has for one.
struct PartedOrder {
  static constexpr std::uint32_t kParts = 2;

  std::vector<std::uint32_t> nodes;  ///< n: a permutation
  std::uint32_t second = 0;          ///< where the second part begins
  std::uint32_t rest = 0;            ///< where the rest begins; 0 where there is nothing else

  std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(nodes.size()); }
  std::uint32_t parts() const noexcept { return rest > 0 ? kParts : 0; }
  std::uint32_t begin(std::uint32_t part) const noexcept { return part == 0 ? 0 : second; }
  std::uint32_t end(std::uint32_t part) const noexcept { return part == 0 ? second : rest; }
};

/// Small levels are all rest, by number. [DELT-7, Coupled problems] O(n + edges).
PartedOrder order_in_parts(const Level& level);

}  // namespace deltamesh::settling
