// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What is remembered of coded vertices, and what of it is said of the next one. Integers only; shared by
// writer and reader [FLD-2, FLD-3].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "base/four_ints.h"
#include "base/large_vector.h"
#include "topology/adjacency.h"

namespace deltamesh {

inline constexpr std::int32_t kFieldUnit = 16;            ///< fixed point: parts of a step
inline constexpr std::int32_t kLargestRemembered = 8191;  ///< of a number
inline constexpr std::int32_t kLargestMultiplied = 2047;  ///< of the factors of a product

/// Numbers about a vertex, in 1/16 steps and 1/16 squared steps [FLD-2].
struct FieldMemory {
  FourInts numbers;     ///< x, y, z, 0
  FourInts magnitudes;  ///< smoothed absolute values; the last is the smoothed product yz
  FourInts products;    ///< xx, xy, xz, yy, smoothed
};

/// What is known of a vertex before it is coded [FLD-3].
struct FieldNeighborhood {
  FieldMemory means;           ///< over the coded neighbours, 0 without any
  unsigned count = 0;          ///< of these
  std::uint32_t degree_class;  ///< of the vertex itself, in the whole graph: 0 to 7
};

/// Vertices are coded in the order of two walks that take turns, one from vertex 0, one from `middle`
/// [FLD-8].
class FieldHistory {
 public:
  FieldHistory(const Adjacency& graph, std::uint32_t middle)
      : graph_(graph), middle_(middle), memories_(graph.vertex_count() + 1) {
    memories_[graph.vertex_count()] = FieldMemory{};
  }

  /// `steps`: vertices that are coded of either walk.
  [[gnu::always_inline]] FieldNeighborhood around(std::uint32_t vertex, std::uint32_t steps) const noexcept {
    FieldNeighborhood around;
    const auto row = graph_.of(vertex);
    const auto degree = static_cast<std::uint32_t>(row.size());
    around.degree_class = std::clamp<std::uint32_t>(degree, 3, 10) - 3;
    const auto nothing = static_cast<std::uint32_t>(graph_.vertex_count());
    FieldMemory sums{};
    for (const std::uint32_t neighbor : row.first(std::min<std::size_t>(degree, kMostNeighbors))) {
      // Without branches on what is coded, which would often go wrong.
      const bool counts = (neighbor < steps) | (neighbor - middle_ < steps);
      const FieldMemory& memory = memories_[counts ? neighbor : nothing];
      around.count += counts ? 1 : 0;
      sums.numbers += memory.numbers;
      sums.magnitudes += memory.magnitudes;
      sums.products += memory.products;
    }
    around.means =
        FieldMemory{mean_lanes(sums.numbers, around.count), mean_lanes(sums.magnitudes, around.count),
                    mean_lanes(sums.products, around.count)};
    return around;
  }

  /// `r`: the vertex' numbers, cut to kLargestRemembered.
  [[gnu::always_inline]] void remember(std::uint32_t vertex, const std::array<std::int32_t, 3>& r,
                                       const FieldNeighborhood& around) noexcept {
    std::array<std::int32_t, 3> f{};
    for (std::size_t a = 0; a < 3; ++a) f[a] = std::clamp(r[a], -kLargestMultiplied, kLargestMultiplied);
    const FourInts numbers = FourInts{r[0], r[1], r[2], 0} * kFieldUnit;
    FourInts magnitudes = lane_sizes(numbers);
    magnitudes[3] = f[1] * f[2] * kFieldUnit;
    const FourInts products = FourInts{f[0] * f[0], f[0] * f[1], f[0] * f[2], f[1] * f[1]} * kFieldUnit;
    FieldMemory& memory = memories_[vertex];
    if (around.count == 0) {
      memory = FieldMemory{numbers, magnitudes, products};
    } else {
      memory = FieldMemory{numbers, smooth_lanes(magnitudes, around.means.magnitudes),
                           smooth_lanes(products, around.means.products)};
    }
  }

 private:
  static constexpr unsigned kMostNeighbors = 16;  ///< so that no sum leaves 30 bits
  static_assert(kMostNeighbors <= kMostMeaned);

  const Adjacency& graph_;
  std::uint32_t middle_;
  LargeVector<FieldMemory> memories_;  ///< and one of 0
};

}  // namespace deltamesh
