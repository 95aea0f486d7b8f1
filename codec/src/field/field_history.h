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
#include "base/pick_lanes.h"
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

  /// What is known before `vertex` is coded, those before it in its walk being done. Without branches on what
  /// is coded, which would often go wrong.
  [[gnu::always_inline]] FieldNeighborhood around(std::uint32_t vertex) const noexcept {
    FieldNeighborhood around;
    const std::uint32_t begin = graph_.offsets[vertex];
    const std::uint32_t degree = graph_.offsets[vertex + 1] - begin;
    around.degree_class = std::clamp<std::uint32_t>(degree, 3, 10) - 3;
    const std::uint32_t* const row = graph_.neighbors.data() + begin;
    const auto nothing = static_cast<std::uint32_t>(graph_.vertex_count());
    const std::uint32_t walk = vertex < middle_ ? 0 : middle_;
    FieldMemory sums{};
    const auto add = [&](std::uint32_t neighbor, bool exists) {
      const bool counts = (neighbor - walk < vertex - walk) & exists;
      const FieldMemory& memory = memories_[counts ? neighbor : nothing];
      around.count += counts ? 1 : 0;
      sums.numbers += memory.numbers;
      sums.magnitudes += memory.magnitudes;
      sums.products += memory.products;
    };
    if (begin + std::size_t{kUsualNeighbors} <= graph_.neighbors.size()) [[likely]] {
      for (std::uint32_t i = 0; i < kUsualNeighbors; ++i) add(row[i], i < degree);
    } else {
      for (std::uint32_t i = 0; i < std::min(degree, kUsualNeighbors); ++i) add(row[i], true);
    }
    // Rows ascend.
    for (std::uint32_t i = kUsualNeighbors; i < std::min(degree, kMostNeighbors) && row[i] < vertex; ++i)
      add(row[i], true);
    around.means =
        FieldMemory{mean_lanes(sums.numbers, around.count), mean_lanes(sums.magnitudes, around.count),
                    mean_lanes(sums.products, around.count)};
    return around;
  }

  /// `r`: the vertex' numbers, cut to kLargestRemembered.
  [[gnu::always_inline]] void remember(std::uint32_t vertex, const std::array<std::int32_t, 3>& r,
                                       const FieldNeighborhood& around) noexcept {
    const FourInts lanes = four_ints(r);
    const FourInts f = clamp_lanes(lanes, kLargestMultiplied);
    const FourInts numbers = lanes * kFieldUnit;
    const FourInts yz = multiply_short_lanes(pick_lanes<3, 3, 3, 1>(f), pick_lanes<3, 3, 3, 2>(f));
    const FourInts magnitudes = lane_sizes(numbers) + yz * kFieldUnit;
    const FourInts products =
        multiply_short_lanes(pick_lanes<0, 0, 0, 1>(f), pick_lanes<0, 1, 2, 1>(f)) * kFieldUnit;
    FieldMemory& memory = memories_[vertex];
    if (around.count == 0) {
      memory = FieldMemory{numbers, magnitudes, products};
    } else {
      memory = FieldMemory{numbers, smooth_lanes(magnitudes, around.means.magnitudes),
                           smooth_lanes(products, around.means.products)};
    }
  }

 private:
  static constexpr std::uint32_t kUsualNeighbors = 4;  ///< coded ones; more are rare
  static constexpr std::uint32_t kMostNeighbors = 16;  ///< so that no sum leaves 30 bits

  const Adjacency& graph_;
  std::uint32_t middle_;
  LargeVector<FieldMemory> memories_;  ///< and one of 0
};

}  // namespace deltamesh
