// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// FewNeighbors where all edges weigh 1: sums are small numbers, which share a lane with their aggregate.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "laplacian/multigrid_few_codes.h"
#include "laplacian/multigrid_row.h"

namespace deltamesh::multigrid {

/// The three aggregates that weigh most, in falling order; where there are fewer, any with weight 0.
struct UnitFavorites {
  std::array<std::uint32_t, 3> nodes;
  std::array<std::uint32_t, 3> weights;
};

class FewUnitNeighbors {
 public:
  /// Aggregates must be below this.
  static constexpr std::uint32_t kMostNodes = std::uint32_t{1} << 27;

  /// What a seed counts. An aggregate has but one.
  static constexpr std::uint32_t kSeedWeight = 4;

  /// No aggregate weighs more.
  static constexpr std::uint32_t kMostWeight = FewCodes::kMost - 1 + kSeedWeight;

  explicit FewUnitNeighbors(const FewCodes& codes) noexcept
      : low_{.node = codes.low.node | codes.low.is_none},
        high_{.node = codes.high.node | codes.high.is_none} {
    FourInts sum_low = codes.low.is_seed & kMoreOfSeed;
    FourInts sum_high = codes.high.is_seed & kMoreOfSeed;
    count_equal<0, 1, 2, 3>(low_.node, sum_low, sum_high);
    count_equal<0, 1, 2, 3>(high_.node, sum_low, sum_high);
    low_.key = make_key(sum_low, low_.node) & ~codes.low.is_none;
    high_.key = make_key(sum_high, high_.node) & ~codes.high.is_none;
  }

  /// The lower ones among equals.
  UnitFavorites favorites() noexcept {
    const std::array<std::uint32_t, 3> keys{take_heaviest(), take_heaviest(), take_heaviest()};
    UnitFavorites result;
    for (std::size_t k = 0; k < 3; ++k) {
      result.nodes[k] = ~keys[k] % kMostNodes;
      result.weights[k] = keys[k] / kMostNodes;
    }
    return result;
  }

 private:
  struct Half {
    FourInts node;  ///< -1 where there is no neighbour
    FourInts key{};
  };
  static constexpr std::int32_t kMoreOfSeed = kSeedWeight - 1;
  static constexpr int kNodeBits = std::countr_zero(kMostNodes);
  static constexpr std::int32_t kNodeMask = kMostNodes - 1;

  /// The sum, above what the node is short of the highest. Where one of an aggregate's lanes is the seed's,
  /// only the sum of that is whole, and the greatest.
  static FourInts make_key(FourInts sum, FourInts node) noexcept {
    return sum << kNodeBits | (~node & kNodeMask);
  }

  /// Counts every lane of `from` in all that belong to the same aggregate.
  template <int... kLanes>
  void count_equal(FourInts from, FourInts& sum_low, FourInts& sum_high) const noexcept {
    const auto add = [&](FourInts node) {
      sum_low -= low_.node == node;  // true is -1
      sum_high -= high_.node == node;
    };
    (add(__builtin_shufflevector(from, from, kLanes, kLanes, kLanes, kLanes)), ...);
  }

  /// Of keys, which as floats are in the same order; older processors have no instruction for integers.
  static FourInts greater(FourInts a, FourInts b) noexcept {
    const auto x = std::bit_cast<Float4>(a);
    const auto y = std::bit_cast<Float4>(b);
    return std::bit_cast<FourInts>(x > y ? x : y);
  }

  /// The greatest key; leaves none of that aggregate.
  std::uint32_t take_heaviest() noexcept {
    FourInts key = greater(low_.key, high_.key);
    key = greater(key, __builtin_shufflevector(key, key, 2, 3, 0, 1));
    key = greater(key, __builtin_shufflevector(key, key, 1, 0, 3, 2));
    const FourInts node = ~key & kNodeMask;
    low_.key &= low_.node != node;
    high_.key &= high_.node != node;
    return static_cast<std::uint32_t>(key[0]);
  }

  Half low_;
  Half high_;
};

}  // namespace deltamesh::multigrid
