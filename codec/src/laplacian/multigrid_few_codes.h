// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The aggregates of the neighbours of a node that has few, all at once in registers.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/four_ints.h"
#include "laplacian/multigrid_aggregate.h"

namespace deltamesh::multigrid {

struct FewCodes {
  /// How many neighbours there may be, and how many are read, whichever these are.
  static constexpr std::uint32_t kMost = 8;

  /// Of the first four and the others.
  struct Half {
    FourInts node;     ///< aggregate, whatever it may be where there is no neighbour
    FourInts is_seed;  ///< -1 or 0
    FourInts is_none;  ///< -1 where there is no neighbour, or 0
  };

  /// `codes`: as in Aggregates; `neighbors`: of a node that has `degree` of them, and as many more as are
  /// read.
  FewCodes(const std::uint32_t* neighbors, std::size_t degree, const std::uint32_t* codes) noexcept {
    const auto count = static_cast<std::int32_t>(degree);
    low = gather(neighbors, codes, FourInts{0, 1, 2, 3} >= count);
    high = gather(neighbors + 4, codes, FourInts{4, 5, 6, 7} >= count);
  }

  Half low;
  Half high;

 private:
  static Half gather(const std::uint32_t* neighbors, const std::uint32_t* codes, FourInts is_none) noexcept {
    const auto code = [&](int lane) { return static_cast<std::int32_t>(codes[neighbors[lane]]); };
    const FourInts all{code(0), code(1), code(2), code(3)};
    return {all & static_cast<std::int32_t>(~Aggregates::kSeed), all < 0, is_none};
  }
};

}  // namespace deltamesh::multigrid
