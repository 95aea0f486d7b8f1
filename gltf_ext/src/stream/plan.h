// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which primitives share a stream, and what they share inside it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "stream/source.h"

namespace deltamesh::gltf {

/// Vertices that primitives with equal accessors have in common.
struct VertexSource {
  std::size_t primitive = 0;  ///< any that has these accessors; number in the list of sources
};

/// Triangles of one primitive, or of several that are equal.
struct TriangleSource {
  std::size_t primitive = 0;  ///< the first of them; number in the list of sources
  std::size_t vertices = 0;   ///< number in StreamPlan::vertices
};

struct StreamPlan {
  std::vector<VertexSource> vertices;
  std::vector<TriangleSource> groups;
  std::vector<std::size_t> primitives;  ///< numbers in the list of sources, ascending
  std::vector<std::uint32_t> group_of;  ///< of every one of `primitives`: number in `groups`
  /// One vertex source, whose vertices keep their numbers, for something outside counts on them.
  bool exact_order = false;
  /// Number of the lattice on which all streams that border on each other have their positions; see
  /// mark_borders().
  std::optional<std::size_t> lattice{};
};

/// Primitives of one mesh share a stream, so that vertices at equal places stay together whatever is coded
/// with loss; so do primitives of several meshes that use the same vertices. Those with an exact order share
/// with primitives of equal accessors only. In the order of the first primitives. Errors: kInvalidFile,
/// kLimitExceeded (more groups than a stream can have).
Result<std::vector<StreamPlan>> plan_streams(const AccessorStore& store,
                                             const std::vector<PrimitiveSource>& sources);

}  // namespace deltamesh::gltf
