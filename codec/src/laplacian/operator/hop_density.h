// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The paper's v: how far anchors are apart, in edges.
#pragma once

#include <cstdint>
#include <span>

#include "topology/adjacency.h"

namespace deltamesh {

/// Largest hop distance of a vertex to the nearest of `anchors`; vertices that reach none are left out.
/// O(n + edges).
std::uint32_t hop_density(const Adjacency& graph, std::span<const std::uint32_t> anchors);

}  // namespace deltamesh
