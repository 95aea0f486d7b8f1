// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The neighbours of a node that has few, all at once in registers: what they weigh by their aggregates. Sums
// in memory, one neighbour after the other, wait for each other.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "laplacian/multigrid_few_codes.h"
#include "laplacian/multigrid_row.h"

namespace deltamesh::multigrid {

/// The three aggregates that weigh most, in falling order; where there are fewer, with weight 0.
struct Favorites {
  std::array<std::uint32_t, 3> nodes;
  std::array<float, 3> weights;
};

class FewNeighbors {
 public:
  /// `weights`: of the edges, and as many more as FewCodes reads. Seeds count `seed` times.
  FewNeighbors(const FewCodes& codes, const float* weights, float seed) noexcept
      : low_(half(codes.low, weights, seed - 1)), high_(half(codes.high, weights + 4, seed - 1)) {}

  /// The first ones among equals.
  Favorites favorites() const noexcept {
    Half low{low_.node, Float4{}};
    Half high{high_.node, Float4{}};
    add_equal<0, 1, 2, 3>(low_, low, high);
    add_equal<0, 1, 2, 3>(high_, low, high);
    low.weight = with_lanes(low.weight, FourInts{7, 6, 5, 4});
    high.weight = with_lanes(high.weight, FourInts{3, 2, 1, 0});
    const Found a = take_heaviest(low, high);
    const Found b = take_heaviest(low, high);
    const Found c = take_heaviest(low, high);
    return {.nodes = {static_cast<std::uint32_t>(a.node), static_cast<std::uint32_t>(b.node),
                      static_cast<std::uint32_t>(c.node)},
            .weights = {a.weight, b.weight, c.weight}};
  }

 private:
  struct Half {
    FourInts node;
    Float4 weight;
  };
  struct Found {
    std::int32_t node;
    float weight;
  };
  static constexpr std::int32_t kLane = 7;  ///< the lowest bits of a weight, which tell where it is from

  static Half half(const FewCodes::Half& codes, const float* weights, float more) noexcept {
    Float4 weight;
    std::memcpy(&weight, weights, sizeof(weight));
    const Float4 factor = 1.0F + masked(Float4{more, more, more, more}, codes.is_seed);
    return {codes.node, masked(weight * factor, ~codes.is_none)};
  }

  static Float4 masked(Float4 values, FourInts mask) noexcept {
    return std::bit_cast<Float4>(std::bit_cast<FourInts>(values) & mask);
  }
  static Float4 with_lanes(Float4 values, FourInts lanes) noexcept {
    return std::bit_cast<Float4>((std::bit_cast<FourInts>(values) & ~kLane) | lanes);
  }

  /// Adds the weights of `from`, each to all that belong to the same aggregate.
  template <int... kLanes>
  static void add_equal(const Half& from, Half& low, Half& high) noexcept {
    const auto add = [&](FourInts node, Float4 weight) {
      low.weight += masked(weight, low.node == node);
      high.weight += masked(weight, high.node == node);
    };
    (add(__builtin_shufflevector(from.node, from.node, kLanes, kLanes, kLanes, kLanes),
         __builtin_shufflevector(from.weight, from.weight, kLanes, kLanes, kLanes, kLanes)),
     ...);
  }

  static Float4 greater(Float4 a, Float4 b) noexcept { return a > b ? a : b; }
  static float greatest(Float4 a, Float4 b) noexcept {
    Float4 most = greater(a, b);
    most = greater(most, __builtin_shufflevector(most, most, 2, 3, 0, 1));
    most = greater(most, __builtin_shufflevector(most, most, 1, 0, 3, 2));
    return most[0];
  }

  /// Leaves nothing of it.
  static Found take_heaviest(Half& low, Half& high) noexcept {
    const auto key = std::bit_cast<std::int32_t>(greatest(low.weight, high.weight));
    std::int32_t nodes[FewCodes::kMost];
    std::memcpy(nodes, &low.node, sizeof(low.node));
    std::memcpy(nodes + 4, &high.node, sizeof(high.node));
    const std::int32_t node = nodes[kLane - (key & kLane)];
    low.weight = masked(low.weight, low.node != node);
    high.weight = masked(high.weight, high.node != node);
    return {node, std::bit_cast<float>(key & ~kLane)};
  }

  Half low_;
  Half high_;
};

}  // namespace deltamesh::multigrid
