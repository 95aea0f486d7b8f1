// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The aggregates of the neighbours of a node that has few, all at once in registers.
#pragma once

#include <cstddef>
#include <cstdint>

#include "laplacian/multigrid_aggregate.h"
#include "laplacian/multigrid_level.h"

namespace deltamesh::multigrid {

using FourNodes = std::int32_t __attribute__((vector_size(16)));

struct FewCodes {
  /// How many neighbours there may be, and how many are read, whichever these are.
  static constexpr std::uint32_t kMost = 8;

  /// Of the first four and the others.
  struct Half {
    FourNodes node;     ///< aggregate, whatever it may be where there is no neighbour
    FourNodes is_seed;  ///< -1 or 0
    FourNodes is_none;  ///< -1 where there is no neighbour, or 0
  };

  static bool can_read(const Level& level, std::uint32_t node) noexcept {
    const std::size_t begin = level.offsets[node];
    return level.offsets[node + 1] - begin <= kMost && begin + kMost <= level.neighbors.size();
  }

  /// `codes`: as in Aggregates.
  FewCodes(const Level& level, std::uint32_t node, const std::uint32_t* codes) noexcept {
    const std::uint32_t* const neighbors = level.neighbors.data() + level.offsets[node];
    const auto degree = static_cast<std::int32_t>(level.offsets[node + 1] - level.offsets[node]);
    low = gather(neighbors, codes, FourNodes{0, 1, 2, 3} >= degree);
    high = gather(neighbors + 4, codes, FourNodes{4, 5, 6, 7} >= degree);
  }

  Half low;
  Half high;

 private:
  static Half gather(const std::uint32_t* neighbors, const std::uint32_t* codes, FourNodes is_none) noexcept {
    const auto code = [&](int lane) { return static_cast<std::int32_t>(codes[neighbors[lane]]); };
    const FourNodes all{code(0), code(1), code(2), code(3)};
    return {all & static_cast<std::int32_t>(~Aggregates::kSeed), all < 0, is_none};
  }
};

}  // namespace deltamesh::multigrid
