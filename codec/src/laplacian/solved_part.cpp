// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/solved_part.h"

#include "laplacian/anchors.h"

namespace deltamesh {

SolvedPart extract_solved_part(const Adjacency& graph, const Components& components) {
  SolvedPart part;
  part.rows.assign(graph.vertex_count(), SolvedPart::kNoRow);
  for (std::uint32_t vertex = 0; vertex < graph.vertex_count(); ++vertex) {
    if (components.size[components.label[vertex]] < kSmallestSolvedComponent) continue;
    part.rows[vertex] = static_cast<std::uint32_t>(part.vertices.size());
    part.vertices.push_back(vertex);
  }
  part.graph.offsets.reserve(part.vertices.size() + 1);
  part.graph.offsets.push_back(0);
  part.graph.neighbors.reserve(graph.neighbors.size());
  for (const std::uint32_t vertex : part.vertices) {
    for (const std::uint32_t neighbor : graph.of(vertex)) part.graph.neighbors.push_back(part.rows[neighbor]);
    part.graph.offsets.push_back(static_cast<std::uint32_t>(part.graph.neighbors.size()));
  }
  return part;
}

}  // namespace deltamesh
