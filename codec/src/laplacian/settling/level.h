// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// One level of the multigrid hierarchy: a weighted graph, its mass, its anchors, and the way to the next
// coarser level.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/large_vector.h"
#include "laplacian/settling/chunks.h"
#include "laplacian/settling/row.h"
#include "topology/adjacency.h"

namespace deltamesh::settling {

/// Edges to lower nodes, and edges to higher ones, come in multiples of so many on coarse levels [pad_rows].
inline constexpr std::uint32_t kEdgesAtOnce = 2;

/// The equations  K x + M s = b_x,  K s = b_s  on a graph, K = D - A with edge weights A. A finest level that
/// was coarsened quickly has neither D nor M.
struct Level {
  std::span<const std::uint32_t> offsets;    ///< n + 1
  std::span<const std::uint32_t> neighbors;  ///< two entries per edge; on coarse levels first the lower ones
  Adjacency storage;                         ///< what they show, but on the finest level
  LargeVector<std::uint32_t> middle;  ///< n: where the edges to higher nodes begin; empty on the finest level
  LargeVector<float> weights;         ///< beside `neighbors`; empty on the finest level: all 1
  LargeVector<float> degree;          ///< n: D, the sum of a node's edge weights; 0 for a lone node
  LargeVector<float> inverse_degree;  ///< n: 1 / D; 0 for a lone node
  LargeVector<float> mass;            ///< n: M, above 0 where D is; D^2 on the finest level
  std::uint64_t edge_ends = 0;        ///< neighbours, without those of pad_rows()
  std::vector<std::uint32_t> anchors;        ///< node of every anchor; distinct
  LargeVector<Interpolation> interpolation;  ///< n; empty on the coarsest level
  Chunks chunks;                             ///< of all nodes

  std::uint32_t node_count() const noexcept { return static_cast<std::uint32_t>(offsets.size() - 1); }
  bool has_unit_weights() const noexcept { return weights.empty(); }
  float weight(std::uint32_t edge) const noexcept { return weights.empty() ? 1.0F : weights[edge]; }
};

}  // namespace deltamesh::settling
