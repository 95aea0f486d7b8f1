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
  EightShorts numbers_and_sizes;  ///< x, y, z, degree; smoothed absolute values in 1/16 steps, 1
  EightShorts ties_and_errors;    ///< how much xy, xz, yz go together; smoothed distances to references
};

/// What is known of a vertex before it is coded [FLD-10].
struct LargeFieldSurroundings {
  LargeFieldMemory means;   ///< over its peers; of the ties half of that
  EightShorts reference;    ///< numbers of the last peer of the same degree
  std::uint32_t degree;     ///< cut to kLargeFieldCut
  std::uint32_t has_peers;  ///< 1 where peers have its degree, 0 where they are any neighbours
};

/// Vertices from `begin` on are coded one after the other, and know of none before.
class LargeFieldWalk {
 public:
  /// `graph` must outlive this.
  LargeFieldWalk(const Adjacency& graph, std::uint32_t begin, std::uint32_t count)
      : graph_(graph), begin_(begin), memories_(std::size_t{count} + 1) {
    memories_[0] = LargeFieldMemory{.numbers_and_sizes = {0, 0, 0, -1, 0, 0, 0, 0}, .ties_and_errors = {}};
  }

  /// What is known before `vertex` is coded, all before it being done. Without branches on what is coded,
  /// which would often go wrong.
  [[gnu::always_inline]] LargeFieldSurroundings around(std::uint32_t vertex) const noexcept {
    const std::uint32_t row = graph_.offsets[vertex];
    const std::uint32_t degree = graph_.offsets[vertex + 1] - row;
    const std::uint32_t* neighbors = graph_.neighbors.data() + row;
    std::array<std::uint32_t, kNeighbors> few;
    if (degree < kNeighbors) [[unlikely]] {
      std::fill(std::copy_n(neighbors, degree, few.begin()), few.end(), vertex);
      neighbors = few.data();
    }
    const std::uint32_t known = vertex - begin_;
    const std::uint32_t cut_degree = std::min<std::uint32_t>(degree, kLargeFieldCut);
    const EightShorts degrees = all_lanes(static_cast<std::int32_t>(cut_degree));
    LargeFieldMemory all{};
    LargeFieldMemory peers{};
    EightShorts reference{};
    const auto add = [&](std::uint32_t neighbor) {
      const std::uint32_t place = neighbor - begin_;
      const std::uint32_t if_known = place < known ? ~0U : 0;
      const LargeFieldMemory& memory = memories_[(place + 1) & if_known];
      const EightShorts equal = memory.numbers_and_sizes == degrees;
      const EightShorts if_peer = __builtin_shufflevector(equal, equal, 3, 3, 3, 3, 3, 3, 3, 3);
      all.numbers_and_sizes = wrapped_sum(all.numbers_and_sizes, memory.numbers_and_sizes);
      all.ties_and_errors = wrapped_sum(all.ties_and_errors, memory.ties_and_errors);
      peers.numbers_and_sizes = wrapped_sum(peers.numbers_and_sizes, memory.numbers_and_sizes & if_peer);
      peers.ties_and_errors = wrapped_sum(peers.ties_and_errors, memory.ties_and_errors & if_peer);
      reference = choose_lanes(if_peer, memory.numbers_and_sizes, reference);
    };
    add(neighbors[0]);
    add(neighbors[1]);
    add(neighbors[2]);
    add(neighbors[3]);
    const EightShorts have_peers = peers.numbers_and_sizes > 0;
    const EightShorts if_peers = __builtin_shufflevector(have_peers, have_peers, 7, 7, 7, 7, 7, 7, 7, 7);
    const EightShorts numbers_and_sizes =
        choose_lanes(if_peers, peers.numbers_and_sizes, all.numbers_and_sizes);
    const EightShorts ties_and_errors = choose_lanes(if_peers, peers.ties_and_errors, all.ties_and_errors);
    const auto count = static_cast<std::uint16_t>(numbers_and_sizes[7]);
    return {
        .means = {.numbers_and_sizes = multiply_high_unsigned(numbers_and_sizes, kFactors[count]),
                  .ties_and_errors = join_halves(multiply_high(ties_and_errors, kHalfFactors[count]),
                                                 multiply_high_unsigned(ties_and_errors, kFactors[count]))},
        .reference = reference,
        .degree = cut_degree,
        .has_peers = static_cast<std::uint32_t>(if_peers[0]) & 1};
  }

  /// `q`: the vertex' numbers.
  [[gnu::always_inline]] void remember(std::uint32_t vertex, const std::array<std::int32_t, 3>& q,
                                       const LargeFieldSurroundings& around) noexcept {
    const FourInts lanes = {q[0], q[1], q[2], static_cast<std::int32_t>(around.degree)};
    const EightShorts most = all_lanes(kLargeFieldCut);
    const EightShorts numbers = smaller_lanes(larger_lanes(pack_lanes(lanes, lanes), -most), most);
    const EightShorts errors = smaller_lanes(lane_sizes(numbers - twice_low(around.reference)), most);
    const EightShorts first = __builtin_shufflevector(numbers, numbers, 0, 0, 1, 3, 0, 0, 1, 3);
    const EightShorts second = __builtin_shufflevector(numbers, numbers, 1, 2, 2, 3, 1, 2, 2, 3);
    const EightShorts opposed = (first ^ second) >> 15;
    const EightShorts least = smaller_lanes(lane_sizes(first), lane_sizes(second)) << 2;
    const EightShorts ties = ((least ^ opposed) - opposed) + around.means.ties_and_errors;
    const EightShorts sizes = rounded_means(lane_sizes(numbers) << 4, around.means.numbers_and_sizes);
    memories_[vertex - begin_ + 1] = LargeFieldMemory{
        .numbers_and_sizes = (join_halves(numbers, sizes) & kAllButLast) | kOneInLast,
        .ties_and_errors =
            join_halves(ties, rounded_means(errors << 4, around.means.ties_and_errors)) & kAllButDegree};
  }

 private:
  static constexpr std::uint32_t kNeighbors = 4;
  static constexpr EightShorts kAllButDegree = {-1, -1, -1, 0, -1, -1, -1, 0};
  static constexpr EightShorts kAllButLast = {-1, -1, -1, -1, -1, -1, -1, 0};
  static constexpr EightShorts kOneInLast = {0, 0, 0, 0, 0, 0, 0, 1};
  using Factors = std::array<EightShorts, kNeighbors + 1>;
  /// By how many are summed up: what makes means of sums, and halves of means.
  static constexpr Factors kFactors = {all_lanes(0), all_lanes(65535), all_lanes(32767), all_lanes(21845),
                                       all_lanes(16383)};
  static constexpr Factors kHalfFactors = {all_lanes(0), all_lanes(32767), all_lanes(16383), all_lanes(10922),
                                           all_lanes(8191)};

  const Adjacency& graph_;
  std::uint32_t begin_;
  LargeVector<LargeFieldMemory> memories_;  ///< behind one of 0, which is nobody's
};

}  // namespace deltamesh
