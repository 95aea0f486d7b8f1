// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What is remembered of the vertices of a large field, and which of it counts for the next one. Integers
// only; shared by writer and reader [FLD-9, FLD-10].
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

/// Of a coded vertex [FLD-10]; two vectors, as these are read and written. Lanes in between are 0.
struct LargeFieldMemory {
  EightShorts numbers_and_sizes;  ///< x, y, z; smoothed absolute values in 1/16 steps, 1
  EightShorts ties_and_errors;    ///< how much yz, xy, xz go together; smoothed distances to references
};

/// Whom of its neighbours a vertex follows, before any of them is coded [FLD-10]. Places are those of
/// memories, 0 is nobody's.
struct LargeFieldPeers {
  std::uint32_t a;
  std::uint32_t b;
  std::uint32_t c;
  std::uint32_t d;
  std::uint32_t last;    ///< the highest place of one with the same degree
  std::uint32_t degree;  ///< of the vertex itself
};

/// Vertices from `begin` on are coded one after the other, and know of none before.
class LargeFieldWalk {
 public:
  /// `graph` must outlive this.
  LargeFieldWalk(const Adjacency& graph, std::uint32_t begin, std::uint32_t count)
      : graph_(graph), begin_(begin), memories_(std::size_t{count} + 1) {
    memories_[0] = LargeFieldMemory{};
  }

  /// Without branches on the degrees of neighbours, which would often go wrong.
  [[gnu::always_inline]] LargeFieldPeers peers(std::uint32_t vertex) const noexcept {
    const std::uint32_t* const offsets = graph_.offsets.data();
    const std::uint32_t row = offsets[vertex];
    const std::uint32_t degree = offsets[vertex + 1] - row;
    const std::uint32_t* neighbors = graph_.neighbors.data() + row;
    std::array<std::uint32_t, kNeighbors> few;
    if (degree < kNeighbors) [[unlikely]] {
      std::fill(std::copy_n(neighbors, degree, few.begin()), few.end(), vertex);
      neighbors = few.data();
    }
    const std::uint32_t known_count = vertex - begin_;
    const auto known = [&](std::uint32_t neighbor) {
      const std::uint32_t place = neighbor - begin_;
      return (place + 1) & (place < known_count ? ~0U : 0);
    };
    const auto if_alike = [&](std::uint32_t neighbor) {
      return if_zero((offsets[neighbor + 1] - offsets[neighbor]) ^ degree);
    };
    const std::uint32_t a = known(neighbors[0]);
    const std::uint32_t b = known(neighbors[1]);
    const std::uint32_t c = known(neighbors[2]);
    const std::uint32_t d = known(neighbors[3]);
    const std::uint32_t peer_a = a & if_alike(neighbors[0]);
    const std::uint32_t peer_b = b & if_alike(neighbors[1]);
    const std::uint32_t peer_c = c & if_alike(neighbors[2]);
    const std::uint32_t peer_d = d & if_alike(neighbors[3]);
    const std::uint32_t if_none = if_zero(peer_a | peer_b | peer_c | peer_d);
    return {.a = peer_a | (a & if_none),
            .b = peer_b | (b & if_none),
            .c = peer_c | (c & if_none),
            .d = peer_d | (d & if_none),
            .last = std::max(std::max(peer_a, peer_b), std::max(peer_c, peer_d)),
            .degree = degree};
  }

  /// Over the peers.
  [[gnu::always_inline]] LargeFieldMemory sums(const LargeFieldPeers& peers) const noexcept {
    const auto sum = [&](auto lanes) {
      return wrapped_sum(wrapped_sum(memories_[peers.a].*lanes, memories_[peers.b].*lanes),
                         wrapped_sum(memories_[peers.c].*lanes, memories_[peers.d].*lanes));
    };
    return {.numbers_and_sizes = sum(&LargeFieldMemory::numbers_and_sizes),
            .ties_and_errors = sum(&LargeFieldMemory::ties_and_errors)};
  }

  const LargeFieldMemory& memory(std::uint32_t place) const noexcept { return memories_[place]; }
  void remember(std::uint32_t vertex, const LargeFieldMemory& memory) noexcept {
    memories_[vertex - begin_ + 1] = memory;
  }

 private:
  static constexpr std::size_t kNeighbors = 4;

  /// All ones for 0, else 0. `x`: below 2^31.
  static std::uint32_t if_zero(std::uint32_t x) noexcept {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(x - 1) >> 31);
  }

  const Adjacency& graph_;
  std::uint32_t begin_;
  LargeVector<LargeFieldMemory> memories_;
};

}  // namespace deltamesh
