// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What is remembered of the vertices of a large field, and what of it is said of the next one. Integers only;
// shared by writer and reader [FLD-9, FLD-10].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "base/eight_shorts.h"
#include "base/large_vector.h"
#include "topology/adjacency.h"

namespace deltamesh {

inline constexpr std::int32_t kLargeFieldCut = 1023;  ///< most of a number that is remembered

/// Of a coded vertex [FLD-10]; two vectors, as these are read and written.
struct LargeFieldMemory {
  EightShorts numbers_and_sizes;  ///< x, y, z, 0; smoothed absolute values in 1/16 steps, 0
  EightShorts ties_and_errors;    ///< how much xy, xz, yz go together; smoothed distances to references
};

/// What is known of a vertex before it is coded [FLD-10].
struct LargeFieldSurroundings {
  LargeFieldMemory means;      ///< over its peers; of the ties half of that
  EightShorts reference;       ///< numbers of the last peer
  std::uint32_t degree_class;  ///< 0 to 7
  std::uint32_t has_peers;     ///< 1 where peers have its degree, 0 where they are any neighbours
};

/// Vertices from `begin` on are coded one after the other, and know of none before.
class LargeFieldWalk {
 public:
  /// `graph` must outlive this.
  LargeFieldWalk(const Adjacency& graph, std::uint32_t begin, std::uint32_t count)
      : graph_(graph), begin_(begin), nothing_(count), memories_(std::size_t{count} + 1) {
    memories_[count] = LargeFieldMemory{};
  }

  /// What is known before `vertex` is coded, all before it being done. Without branches on what is coded,
  /// which would often go wrong.
  [[gnu::always_inline]] LargeFieldSurroundings around(std::uint32_t vertex) const noexcept {
    const std::uint32_t* const offsets = graph_.offsets.data();
    const std::uint32_t row = offsets[vertex];
    const std::uint32_t degree = offsets[vertex + 1] - row;
    std::array<std::uint32_t, kNeighbors> places;
    std::array<std::uint32_t, kNeighbors> are_peers;
    const auto look_at = [&](std::size_t i, std::uint32_t neighbor, bool exists) {
      const std::uint32_t counts = (neighbor - begin_ < vertex - begin_) & exists ? ~0U : 0;
      const bool is_peer = offsets[neighbor + 1] - offsets[neighbor] == degree;
      places[i] = ((neighbor - begin_) & counts) | (nothing_ & ~counts);
      are_peers[i] = is_peer ? counts : 0;
    };
    if (row + std::size_t{kNeighbors} <= graph_.neighbors.size()) [[likely]] {
      for (std::uint32_t i = 0; i < kNeighbors; ++i) look_at(i, graph_.neighbors[row + i], i < degree);
    } else {
      for (std::uint32_t i = 0; i < kNeighbors; ++i)
        look_at(i, i < degree ? graph_.neighbors[row + i] : vertex, true);
    }
    return summed_up(places, are_peers, degree);
  }

  /// `r`: the vertex' numbers, cut to kLargeFieldCut.
  [[gnu::always_inline]] void remember(std::uint32_t vertex, const std::array<std::int32_t, 3>& r,
                                       const LargeFieldSurroundings& around) noexcept {
    const auto x = static_cast<std::int16_t>(r[0]);
    const auto y = static_cast<std::int16_t>(r[1]);
    const auto z = static_cast<std::int16_t>(r[2]);
    const EightShorts numbers = {x, y, z, 0, x, y, z, 0};
    const EightShorts sizes = lane_sizes(numbers);
    const EightShorts errors =
        smaller_lanes(lane_sizes(numbers - twice_low(around.reference)), EightShorts{} + kLargeFieldCut);
    const EightShorts first = __builtin_shufflevector(numbers, numbers, 0, 0, 1, 3, 0, 0, 1, 3);
    const EightShorts second = __builtin_shufflevector(numbers, numbers, 1, 2, 2, 3, 1, 2, 2, 3);
    const EightShorts opposed = (first ^ second) >> 15;
    const EightShorts least = smaller_lanes(lane_sizes(first), lane_sizes(second)) << 2;
    const EightShorts ties = ((least ^ opposed) - opposed) + around.means.ties_and_errors;
    memories_[vertex - begin_] = LargeFieldMemory{
        .numbers_and_sizes = join_halves(numbers, rounded_means(sizes << 4, around.means.numbers_and_sizes)),
        .ties_and_errors = join_halves(ties, rounded_means(errors << 4, around.means.ties_and_errors))};
  }

 private:
  static constexpr std::uint32_t kNeighbors = 4;

  [[gnu::always_inline]] LargeFieldSurroundings summed_up(
      const std::array<std::uint32_t, kNeighbors>& places,
      const std::array<std::uint32_t, kNeighbors>& are_peers, std::uint32_t degree) const noexcept {
    const std::uint32_t any = are_peers[0] | are_peers[1] | are_peers[2] | are_peers[3];
    LargeFieldMemory sums{};
    std::uint32_t count = 0;
    std::uint32_t last = nothing_;
    for (std::size_t i = 0; i < kNeighbors; ++i) {
      const std::uint32_t place = (any & ~are_peers[i]) != 0 ? nothing_ : places[i];
      const bool counts = place != nothing_;
      count += counts ? 1 : 0;
      last = counts ? place : last;
      sums.numbers_and_sizes += memories_[place].numbers_and_sizes;
      sums.ties_and_errors += memories_[place].ties_and_errors;
    }
    constexpr std::array<std::uint16_t, kNeighbors + 1> kFactors = {0, 65535, 32767, 21845, 16383};
    const std::uint32_t factor = kFactors[count];
    return {.means = {.numbers_and_sizes = multiply_high_unsigned(sums.numbers_and_sizes, factor),
                      .ties_and_errors = join_halves(
                          multiply_high(sums.ties_and_errors, static_cast<std::int32_t>(factor / 2)),
                          multiply_high_unsigned(sums.ties_and_errors, factor))},
            .reference = memories_[last].numbers_and_sizes,
            .degree_class = std::clamp<std::uint32_t>(degree, 3, 10) - 3,
            .has_peers = any & 1};
  }

  const Adjacency& graph_;
  std::uint32_t begin_;
  std::uint32_t nothing_;  ///< place of what is not there
  LargeVector<LargeFieldMemory> memories_;
};

}  // namespace deltamesh
