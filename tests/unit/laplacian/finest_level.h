// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "laplacian/multigrid/setup/levels.h"
#include "support/graph_mesh.h"

namespace deltamesh::test {

/// The finest level of `mesh` with the arrays of a coarse one: weights of 1, and what follows from them.
/// Refers to its graph.
inline multigrid::Level finest_level(const GraphMesh& mesh, const std::vector<std::uint32_t>& anchors) {
  multigrid::Level level = multigrid::finest_level(mesh.graph, anchors);
  level.weights.assign(level.neighbors.size(), 1.0F);
  for (std::uint32_t i = 0; i < level.node_count(); ++i) {
    const auto row = mesh.graph.of(i);
    const auto lower = std::lower_bound(row.begin(), row.end(), i) - row.begin();
    const float degree = multigrid::unit_degree(level, i);
    level.middle.push_back(level.offsets[i] + static_cast<std::uint32_t>(lower));
    level.degree.push_back(degree);
    level.inverse_degree.push_back(1 / degree);
    level.mass.push_back(degree * degree);
  }
  return level;
}

}  // namespace deltamesh::test
