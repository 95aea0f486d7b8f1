// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// One level of the multigrid hierarchy: a weighted graph, its mass, its anchors, and the interpolation from
// the next coarser level.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/memory/large_vector.h"
#include "laplacian/multigrid/level/interpolation.h"
#include "topology/adjacency.h"

namespace deltamesh::multigrid {

/// The equations  K x + M s = b,  K s = t  on a graph, K = D - A with edge weights A [DELT-7]. The finest
/// level has weights of 1 and, before add_weights(), no arrays for them: D and M follow from the numbers of
/// neighbours.
struct Level {
  std::span<const std::uint32_t> offsets;    ///< n + 1
  std::span<const std::uint32_t> neighbors;  ///< two entries per edge; on coarse levels first the lower ones
  Adjacency storage;                         ///< what they show, but on the finest level
  LargeVector<std::uint32_t> middle;  ///< n: where the edges to higher nodes begin; empty on the finest level
  LargeVector<float> weights;         ///< beside `neighbors`; empty on the finest level
  LargeVector<float> degree;          ///< n: D, the sum of a node's weights, 0 without edges; empty likewise
  LargeVector<float> inverse_degree;  ///< n: 1 / D, or 0; empty likewise
  LargeVector<float> mass;            ///< n: M, above 0; empty likewise
  std::vector<std::uint32_t> anchors;        ///< node of every anchor of the level; distinct
  std::vector<std::uint32_t> finer_anchors;  ///< beside `anchors`: which one of the finer level's it is
  LargeVector<Interpolation> interpolation;  ///< n: rows of P; empty on the coarsest level

  std::uint32_t node_count() const noexcept { return static_cast<std::uint32_t>(offsets.size() - 1); }
  std::size_t edge_count() const noexcept { return neighbors.size() / 2; }
};

}  // namespace deltamesh::multigrid
