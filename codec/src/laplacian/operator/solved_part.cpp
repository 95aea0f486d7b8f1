// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/operator/solved_part.h"

#include <utility>

#include "laplacian/anchors/anchors.h"
#include "topology/subgraph.h"

namespace deltamesh {

SolvedPart extract_solved_part(Adjacency graph, Components components) {
  SolvedPart part{.graph = std::move(graph), .components = std::move(components)};
  part.whole_count = part.graph.vertex_count();
  for_each_run(part.components, [&](std::uint32_t begin, std::uint32_t end, std::uint32_t component) {
    if (part.components.size[component] >= kSmallestSolvedComponent) part.vertices.append(begin, end);
  });
  part.row_count = part.vertices.size();
  if (part.is_whole()) return part;
  keep_vertices(part.graph, part.vertices);
  part.components = pick_components(part.components, part.vertices);
  return part;
}

}  // namespace deltamesh
