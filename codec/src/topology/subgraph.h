// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Some components of a graph as a graph of their own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

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

/// Number of equal labels at the front; `size`: of the component that they belong to, usually the result.
std::size_t run_length(std::span<const std::uint32_t> labels, std::size_t size) noexcept;

/// visit(begin, end, component) for vertices begin .. end - 1, of first .. last - 1, in ascending order.
/// O(n).
template <class Visit>
void for_each_run(const Components& components, std::uint32_t first, std::uint32_t last, const Visit& visit) {
  const std::span labels(components.label);
  for (std::uint32_t begin = first, end = first; begin < last; begin = end) {
    const std::uint32_t label = labels[begin];
    end +=
        static_cast<std::uint32_t>(run_length(labels.subspan(begin, last - begin), components.size[label]));
    visit(begin, end, label);
  }
}

/// The same of all vertices.
template <class Visit>
void for_each_run(const Components& components, const Visit& visit) {
  for_each_run(components, 0, static_cast<std::uint32_t>(components.label.size()), visit);
}

}  // namespace deltamesh
