// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Some components of a graph as a graph of their own.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "topology/adjacency.h"

namespace deltamesh {

/// `kept`: ascending vertices that make up whole components; kept[i] becomes vertex i. O(n + edges).
Adjacency copy_vertices(const Adjacency& graph, std::span<const std::uint32_t> kept);

/// Where `kept` are among `count` vertices, in an eighth of a byte each.
std::vector<bool> mark_vertices(std::span<const std::uint32_t> kept, std::size_t count);

/// The first values go, in order, to where `marks` are; what is elsewhere is anything. As many values as
/// marks. O(n).
template <class T>
void spread_to_marks(std::span<T> values, const std::vector<bool>& marks) {
  auto from = static_cast<std::size_t>(std::count(marks.begin(), marks.end(), true));
  for (std::size_t to = marks.size(); from > 0;) {
    if (marks[--to]) values[to] = values[--from];
  }
}

/// The same in place.
void keep_vertices(Adjacency& graph, std::span<const std::uint32_t> kept);

/// The components of such a graph, without a search; `components`: of the whole graph. O(n).
Components pick_components(const Components& components, std::span<const std::uint32_t> kept);

}  // namespace deltamesh
