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

#include "laplacian/multigrid_aggregate.h"
#include "laplacian/multigrid_row.h"

namespace deltamesh::multigrid {

/// The three aggregates that weigh most, in falling order; where there are fewer, with weight 0.
struct Favorites {
  std::array<std::uint32_t, 3> nodes;
  std::array<float, 3> weights;
};

class FewNeighbors {
 public:
  /// How many there may be, and how many are read, whichever these are.
  static constexpr std::uint32_t kMost = 8;

  /// `weights`: beside `neighbors`. `codes`: as in Aggregates. Seeds count `seed` times.
  FewNeighbors(const std::uint32_t* neighbors, const float* weights, std::uint32_t degree,
               const std::uint32_t* codes, float seed) noexcept
      : low_(half(neighbors, weights, codes, seed - 1)),
        high_(half(neighbors + 4, weights + 4, codes, seed - 1)) {
    const auto count = static_cast<std::int32_t>(degree);
    low_.weight = masked(low_.weight, Lanes{0, 1, 2, 3} < count);
    high_.weight = masked(high_.weight, Lanes{4, 5, 6, 7} < count);
  }

  /// The first ones among equals.
  Favorites favorites() const noexcept {
    Half low{low_.node, Float4{}};
    Half high{high_.node, Float4{}};
    add_equal<0, 1, 2, 3>(low_, low, high);
    add_equal<0, 1, 2, 3>(high_, low, high);
    low.weight = with_lanes(low.weight, Lanes{7, 6, 5, 4});
    high.weight = with_lanes(high.weight, Lanes{3, 2, 1, 0});
    const Found a = take_heaviest(low, high);
    const Found b = take_heaviest(low, high);
    const Found c = take_heaviest(low, high);
    return {.nodes = {static_cast<std::uint32_t>(a.node), static_cast<std::uint32_t>(b.node),
                      static_cast<std::uint32_t>(c.node)},
            .weights = {a.weight, b.weight, c.weight}};
  }

 private:
  using Lanes = std::int32_t __attribute__((vector_size(16)));
  struct Half {
    Lanes node;
    Float4 weight;
  };
  struct Found {
    std::int32_t node;
    float weight;
  };
  static constexpr std::int32_t kLane = 7;  ///< the lowest bits of a weight, which tell where it is from

  static Half half(const std::uint32_t* neighbors, const float* weights, const std::uint32_t* codes,
                   float more) noexcept {
    const auto code = [&](int lane) { return static_cast<std::int32_t>(codes[neighbors[lane]]); };
    const Lanes all{code(0), code(1), code(2), code(3)};
    const Float4 factor = 1.0F + masked(Float4{more, more, more, more}, all < 0);
    Float4 weight;
    std::memcpy(&weight, weights, sizeof(weight));
    return {all & static_cast<std::int32_t>(~Aggregates::kSeed), weight * factor};
  }

  static Float4 masked(Float4 values, Lanes mask) noexcept {
    return std::bit_cast<Float4>(std::bit_cast<Lanes>(values) & mask);
  }
  static Float4 with_lanes(Float4 values, Lanes lanes) noexcept {
    return std::bit_cast<Float4>((std::bit_cast<Lanes>(values) & ~kLane) | lanes);
  }

  /// Adds the weights of `from`, each to all that belong to the same aggregate.
  template <int... kLanes>
  static void add_equal(const Half& from, Half& low, Half& high) noexcept {
    const auto add = [&](Lanes node, Float4 weight) {
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
    std::int32_t nodes[kMost];
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
