// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "laplacian/multigrid/setup/levels.h"
#include "support/graph_mesh.h"

namespace deltamesh::test {

/// The finest level of `mesh`, with weights. Refers to its graph.
inline multigrid::Level finest_level(const GraphMesh& mesh, const std::vector<std::uint32_t>& anchors) {
  auto levels = multigrid::build_levels(mesh.graph, anchors);
  multigrid::add_weights(levels.front());
  return std::move(levels.front());
}

}  // namespace deltamesh::test
