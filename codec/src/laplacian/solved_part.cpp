// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/solved_part.h"

#include <algorithm>
#include <utility>

#include "base/large_vector.h"
#include "laplacian/anchors.h"
#include "topology/subgraph.h"

namespace deltamesh {

std::optional<std::uint32_t> SolvedPart::row_of(std::uint32_t vertex) const noexcept {
  if (is_whole()) return vertex;
  const auto found = std::lower_bound(vertices.begin(), vertices.end(), vertex);
  if (found == vertices.end() || *found != vertex) return std::nullopt;
  return static_cast<std::uint32_t>(found - vertices.begin());
}

SolvedPart extract_solved_part(Adjacency graph, Components components) {
  const std::size_t whole_count = graph.vertex_count();
  SolvedPart part{.graph = std::move(graph),
                  .components = std::move(components),
                  .row_count = whole_count,
                  .whole_count = whole_count};
  const auto is_solved = [](std::uint32_t size) { return size >= kSmallestSolvedComponent; };
  const Components& all = part.components;
  if (std::all_of(all.size.begin(), all.size.end(), is_solved)) return part;
  part.row_count = 0;
  for (const std::uint32_t size : all.size) part.row_count += is_solved(size) ? size : 0;
  reserve_large(part.vertices, part.row_count);
  for (std::uint32_t vertex = 0; vertex < whole_count; ++vertex) {
    if (is_solved(all.size[all.label[vertex]])) part.vertices.push_back(vertex);
  }
  keep_vertices(part.graph, part.vertices);
  part.components = pick_components(all, part.vertices);
  return part;
}

}  // namespace deltamesh
