// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Some components of a graph as a graph of their own.
#pragma once

#include <cstdint>
#include <span>

#include "topology/adjacency.h"

namespace deltamesh {

/// `kept`: ascending vertices that make up whole components; kept[i] becomes vertex i. O(n + edges).
Adjacency copy_vertices(const Adjacency& graph, std::span<const std::uint32_t> kept);

/// The same in place.
void keep_vertices(Adjacency& graph, std::span<const std::uint32_t> kept);

/// The components of such a graph, without a search; `components`: of the whole graph. O(n).
Components pick_components(const Components& components, std::span<const std::uint32_t> kept);

}  // namespace deltamesh
