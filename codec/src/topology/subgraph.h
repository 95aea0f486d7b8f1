// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Some components of a graph as a graph of their own.
#pragma once

#include <cstdint>

#include "topology/adjacency.h"
#include "topology/vertex_subset.h"

namespace deltamesh {

/// `kept`: whole components; their vertices become rows. O(n + edges), mostly much less; where a component is
/// spread over many runs, log(runs) for each edge between them.
Adjacency copy_vertices(const Adjacency& graph, const VertexSubset& kept);

/// The same in place.
void keep_vertices(Adjacency& graph, const VertexSubset& kept);

/// The components of such a graph, without a search; `components`: of the whole graph. O(n).
Components pick_components(const Components& components, const VertexSubset& kept);

/// visit(begin, end, component) for vertices begin .. end - 1, in ascending order. O(n).
template <class Visit>
void for_each_run(const Components& components, const Visit& visit) {
  const auto n = static_cast<std::uint32_t>(components.label.size());
  for (std::uint32_t begin = 0, end = 0; begin < n; begin = end) {
    const std::uint32_t label = components.label[begin];
    for (end = begin + 1; end < n && components.label[end] == label;) ++end;
    visit(begin, end, label);
  }
}

}  // namespace deltamesh
