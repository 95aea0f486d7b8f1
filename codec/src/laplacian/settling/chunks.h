// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The order in which the nodes of a level are worked on, in chunks that do not wait for each other.
#pragma once

#include <cstdint>
#include <vector>

namespace deltamesh::settling {

inline constexpr std::uint32_t kMostChunks = 16;

/// Ranges of nodes that are worked on side by side. What lies between them is left for the end: no node but
/// one of the rim has a neighbour in an earlier chunk, so that any in another one is on the rim, or is
/// interpolated from a coarse node of another one. The chunks of a coarse level are what those of the finer
/// one are interpolated from.
struct Chunks {
  std::vector<std::uint32_t> bounds;     ///< where each begins, and the end
  std::vector<std::uint32_t> rim;        ///< ascending
  std::vector<std::uint32_t> first_rim;  ///< first of every chunk's, and the end
  std::vector<bool> is_on_rim;           ///< for every node; empty where there is but one chunk

  std::uint32_t count() const noexcept { return static_cast<std::uint32_t>(bounds.size()) - 1; }

  /// Calls inner(node) for the others, in every chunk in order, then outer(node) for those on the rim, in
  /// order.
  template <class Inner, class Outer>
  void visit(const Inner& inner, const Outer& outer) const {
    for (std::uint32_t chunk = 0; chunk < count(); ++chunk) {
      std::uint32_t node = bounds[chunk];
      const std::uint32_t last_rim = first_rim[chunk + 1];
      for (std::uint32_t r = first_rim[chunk]; r <= last_rim; ++r, ++node) {
        const std::uint32_t end = r < last_rim ? rim[r] : bounds[chunk + 1];
        for (; node < end; ++node) inner(node);  // called in one place: so it is inlined
      }
    }
    for (const std::uint32_t node : rim) outer(node);
  }

  template <class Each>
  void visit(const Each& each) const {
    visit(each, each);
  }
};

struct Level;

/// `bounds`: as in Chunks, of a level whose interpolation, if any, is from the chunks that `coarse_bounds`
/// tells. O(n + edges).
Chunks make_chunks(const Level& level, std::vector<std::uint32_t> bounds,
                   const std::vector<std::uint32_t>& coarse_bounds);

/// Of the finest level, by its size alone.
std::vector<std::uint32_t> chunk_bounds(std::uint32_t nodes);

}  // namespace deltamesh::settling
