// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Records of coded vertices, and the context of the next one [FLD-13]. Integers only; shared by writer and
// reader.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "base/memory/large_vector.h"
#include "base/simd/eight_shorts.h"
#include "topology/adjacency.h"

namespace deltamesh {

inline constexpr std::int32_t kLargestRemembered = 4095;  ///< of a number: eighths fit into 16 bits

/// The context of a vertex, by axis; means in sixteenths of a step.
struct FieldContext {
  FourInts numbers;            ///< R, over the known neighbours
  FourInts sizes;              ///< G, over the known neighbours and those before them
  FourInts ties;               ///< T, how much xy, xz and yz go together: above 0 where signs are equal
  FourInts errors;             ///< E, over the peers: of differences to the last peer
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

  /// The context of `vertex`. Precondition: remember() was called for all vertices below it. No branches on
  /// the degrees of neighbours, as they would often be mispredicted.
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
    Places known;
    Places peers;
    std::uint32_t any_peer = 0;
    for (std::size_t i = 0; i < kNeighbors; ++i) {
      const std::uint32_t u = neighbors[i];
      known[i] = u < vertex ? u + 1 : 0;
      peers[i] = offsets[u + 1] - offsets[u] == degree ? known[i] : 0;
      any_peer |= peers[i];
    }
    const std::uint32_t without = any_peer == 0 ? ~0U : 0;
    std::uint32_t last = 0;
    for (std::size_t i = 0; i < kNeighbors; ++i) {
      peers[i] |= known[i] & without;
      last = std::max(last, peers[i]);
    }
    const Sums sums = sums_of(known, peers);
    return {.numbers = sums.numbers >> 4,
            .sizes = sums.sizes >> 7,
            .ties = sums.ties >> 7,
            .errors = sums.errors >> 7,
            .last_peer = low_ints(memories_[last].numbers_and_sizes),
            .degree_class = std::clamp<std::uint32_t>(degree, 3, 10) - 3};
  }

  /// `numbers`: of the vertex, cut to kLargestRemembered.
  [[gnu::always_inline]] void remember(std::uint32_t vertex, const std::array<std::int32_t, 3>& numbers,
                                       const FieldContext& around) noexcept {
    const FourInts r = four_ints(numbers);
    const FourInts sizes = ((lane_sizes(r) << 4) + around.sizes) >> 2;
    const FourInts error = smaller_lanes(lane_sizes(r - around.last_peer), FourInts{} + kLargestRemembered);
    const FourInts errors = ((error << 4) + around.errors) >> 2;
    const FourInts first = pick_lanes<0, 0, 1, 3>(r);
    const FourInts second = pick_lanes<1, 2, 2, 3>(r);
    const FourInts opposite = (first ^ second) >> 31;
    const FourInts smaller = smaller_lanes(lane_sizes(first), lane_sizes(second));
    const FourInts ties = ((((smaller ^ opposite) - opposite) << 4) + around.ties) >> 2;
    memories_[vertex + 1] = {.numbers_and_sizes = pack_lanes(r, sizes),
                             .ties_and_errors = pack_lanes(ties, errors)};
  }

 private:
  static constexpr std::size_t kNeighbors = 4;
  using Places = std::array<std::uint32_t, kNeighbors>;  ///< of memories; 0 where there is none
  /// By how many there are.
  static constexpr std::array<std::int32_t, kNeighbors + 1> kShares = {0, 256, 128, 85, 64};

  struct Memory {
    EightShorts numbers_and_sizes;  ///< steps, eighths
    EightShorts ties_and_errors;    ///< eighths
  };

  /// Times 256 what the means are of.
  struct Sums {
    FourInts numbers{};
    FourInts sizes{};
    FourInts ties{};
    FourInts errors{};
  };

  static std::int32_t share_of(const Places& places) noexcept {
    std::size_t count = 0;
    for (const std::uint32_t place : places) count += place != 0 ? 1 : 0;
    return kShares[count];
  }

  /// Two neighbours at a time: products of 16 bits are added in pairs.
  [[gnu::always_inline]] Sums sums_of(const Places& known, const Places& peers) const noexcept {
    const EightShorts share = all_lanes(share_of(known));
    const EightShorts share_of_peers = all_lanes(share_of(peers));
    Sums sums;
    for (std::size_t i = 0; i < kNeighbors; i += 2) {
      const Memory& a = memories_[known[i]];
      const Memory& b = memories_[known[i + 1]];
      sums.numbers += weighted_sums(a.numbers_and_sizes, b.numbers_and_sizes, share);
      sums.sizes += weighted_high_sums(a.numbers_and_sizes, b.numbers_and_sizes, share);
      sums.ties += weighted_sums(a.ties_and_errors, b.ties_and_errors, share);
      sums.errors += weighted_high_sums(memories_[peers[i]].ties_and_errors,
                                        memories_[peers[i + 1]].ties_and_errors, share_of_peers);
    }
    return sums;
  }

  const Adjacency& graph_;
  LargeVector<Memory> memories_;  ///< in front one of 0
};

}  // namespace deltamesh
