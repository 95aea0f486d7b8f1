// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What is remembered of coded vertices, and what of it is said of the next one. Integers only; shared by
// writer and reader [FLD-2, FLD-3].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "topology/adjacency.h"

namespace deltamesh {

/// Numbers about a vertex, in 1/16 steps and 1/16 squared steps [FLD-2].
struct FieldMemory {
  std::array<std::int32_t, 3> q{};
  std::array<std::int32_t, 3> magnitude{};  ///< smoothed absolute values
  std::array<std::int32_t, 6> moments{};    ///< xx, xy, xz, yy, yz, zz, smoothed
};

/// Sums over the coded neighbours of a vertex, divided by their number [FLD-3].
struct FieldNeighborhood {
  FieldMemory means;
  std::uint32_t degree_class = 0;  ///< of the vertex itself, in the whole graph: 0 to 7
  bool empty = true;
};

/// What a caller that predicts the numbers knows of a vertex; 1/16 steps [FLD-7].
struct FieldHint {
  std::array<std::int32_t, 3> spread{};  ///< how far apart the neighbours' values are, 0 to 2^17
  std::array<std::int32_t, 3> offset{};  ///< what rounding took off the prediction, -16 to 16
};

/// What is remembered of every coded vertex [FLD-2].
inline constexpr std::int32_t kFieldUnit = 16;            ///< fixed point: parts of a step
inline constexpr std::int32_t kLargestRemembered = 8191;  ///< of a number
inline constexpr std::int32_t kLargestMultiplied = 2047;  ///< of the factors of a moment

class FieldHistory {
 public:
  explicit FieldHistory(const Adjacency& graph) : graph_(graph), memories_(graph.vertex_count()) {}

  FieldNeighborhood around(std::uint32_t vertex) const noexcept;

  /// `q`: the vertex's deltas; `before`: what around() said of it.
  void remember(std::uint32_t vertex, const std::array<std::int32_t, 3>& q,
                const FieldNeighborhood& before) noexcept;

 private:
  const Adjacency& graph_;
  std::vector<FieldMemory> memories_;
};

}  // namespace deltamesh
