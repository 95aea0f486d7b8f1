// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/problem.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "topology/subgraph.h"

namespace deltamesh::settling {

PartialProblem::PartialProblem(const Problem& whole, VertexSubset vertices)
    : vertices_(std::move(vertices)),
      graph_(copy_vertices(whole.graph, vertices_)),
      components_(pick_components(whole.components, vertices_)),
      step_(whole.step) {
  deltas_.reserve(vertices_.size());
  for (const VertexSubset::Run& run : vertices_.runs()) {
    for (std::uint32_t v = run.begin; v < run.end; ++v) deltas_.push_back(whole.deltas[v]);
    const auto first = std::lower_bound(whole.anchors.begin(), whole.anchors.end(), run.begin);
    for (auto anchor = first; anchor != whole.anchors.end() && *anchor < run.end; ++anchor) {
      anchors_.push_back(run.row + (*anchor - run.begin));
      targets_.push_back(whole.targets[static_cast<std::size_t>(anchor - whole.anchors.begin())]);
    }
  }
}

}  // namespace deltamesh::settling
