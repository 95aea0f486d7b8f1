// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What is remembered of coded vertices, and what it says of the next one. Integers only; shared by writer and
// reader [FLD-13].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "base/eight_shorts.h"
#include "base/large_vector.h"
#include "topology/adjacency.h"

namespace deltamesh {

inline constexpr std::int32_t kLargestRemembered = 8191;  ///< of a number: four of them fit into 16 bits

/// What is known of a vertex before it is coded: means over its peers in twelfths of a step, by axis.
struct FieldContext {
  FourInts numbers;            ///< R
  FourInts sizes;              ///< G: of numbers
  FourInts errors;             ///< E: of differences to the last peer
  FourInts ties;               ///< T, how much xy, xz and yz go together: above 0 where signs are equal
  FourInts last_peer;          ///< L: the numbers of the last peer, steps; 0 where there is none
  std::uint32_t degree_class;  ///< of the vertex itself, 0 to 7
};

/// Vertices come in ascending order.
class FieldHistory {
 public:
  /// `graph` must outlive this.
  explicit FieldHistory(const Adjacency& graph) : graph_(graph), memories_(graph.vertex_count() + 1) {
    memories_[0] = Memory{};
  }

  /// All vertices below `vertex` being remembered. Without branches on the degrees of neighbours, which would
  /// often go wrong.
  [[gnu::always_inline]] FieldContext around(std::uint32_t vertex) const noexcept {
    const std::uint32_t* const offsets = graph_.offsets.data();
    const std::uint32_t row = offsets[vertex];
    const std::uint32_t degree = offsets[vertex + 1] - row;
    const std::uint32_t* neighbors = graph_.neighbors.data() + row;
    std::array<std::uint32_t, kNeighbors> few;
    if (degree < kNeighbors) [[unlikely]] {
      std::fill(std::copy_n(neighbors, degree, few.begin()), few.end(), vertex);
      neighbors = few.data();
    }
    std::array<std::uint32_t, kNeighbors> known;  // places of memories
    std::array<std::uint32_t, kNeighbors> peers;
    std::uint32_t any_peer = 0;
    for (std::size_t i = 0; i < kNeighbors; ++i) {
      const std::uint32_t u = neighbors[i];
      known[i] = u < vertex ? u + 1 : 0;
      peers[i] = offsets[u + 1] - offsets[u] == degree ? known[i] : 0;
      any_peer |= peers[i];
    }
    const std::uint32_t without = any_peer == 0 ? ~0U : 0;
    std::uint32_t count = 0;
    std::uint32_t last = 0;
    Memory sum{};
    for (std::size_t i = 0; i < kNeighbors; ++i) {
      const std::uint32_t place = peers[i] | (known[i] & without);
      const Memory& memory = memories_[place];
      sum.numbers_and_errors += memory.numbers_and_errors;
      sum.sizes_and_ties += memory.sizes_and_ties;
      count += place != 0 ? 1 : 0;
      last = std::max(last, place);
    }
    const FourInts share = FourInts{} + kTwelfths[count];
    return {.numbers = multiply_short_lanes(low_ints(sum.numbers_and_errors), share),
            .sizes = multiply_short_lanes(low_ints(sum.sizes_and_ties), share),
            .errors = multiply_short_lanes(high_ints(sum.numbers_and_errors), share),
            .ties = multiply_short_lanes(high_ints(sum.sizes_and_ties), share),
            .last_peer = low_ints(memories_[last].numbers_and_errors),
            .degree_class = std::clamp<std::uint32_t>(degree, 3, 10) - 3};
  }

  /// `numbers`: of the vertex, cut to kLargestRemembered.
  [[gnu::always_inline]] void remember(std::uint32_t vertex, const std::array<std::int32_t, 3>& numbers,
                                       const FieldContext& around) noexcept {
    const FourInts r = four_ints(numbers);
    const FourInts errors = smaller_lanes(lane_sizes(r - around.last_peer), FourInts{} + kLargestRemembered);
    const FourInts sizes = lane_sizes(r);
    const FourInts first = pick_lanes<0, 0, 1, 3>(r);
    const FourInts second = pick_lanes<1, 2, 2, 3>(r);
    const FourInts opposite = (first ^ second) >> 31;
    const FourInts smaller = smaller_lanes(lane_sizes(first), lane_sizes(second));
    const FourInts ties = (smaller ^ opposite) - opposite;
    memories_[vertex + 1] = {.numbers_and_errors = pack_lanes(r, errors),
                             .sizes_and_ties = pack_lanes(sizes, ties)};
  }

 private:
  static constexpr std::size_t kNeighbors = 4;
  /// By how many peers there are.
  static constexpr std::array<std::int32_t, kNeighbors + 1> kTwelfths = {0, 12, 6, 4, 3};

  struct Memory {
    EightShorts numbers_and_errors;
    EightShorts sizes_and_ties;
  };

  const Adjacency& graph_;
  LargeVector<Memory> memories_;  ///< in front one of 0
};

}  // namespace deltamesh
