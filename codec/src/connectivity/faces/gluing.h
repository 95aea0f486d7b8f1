// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which manifold vertices are one vertex of the mesh: gaps and targets of the glued ones [CONN-11].
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/memory/large_vector.h"
#include "connectivity/faces/border.h"
#include "connectivity/faces/faces.h"
#include "deltamesh/result.h"
#include "entropy/coder/reader.h"

namespace deltamesh {

/// Glued vertices as in the stream; both lists have one entry per glued vertex.
struct GlueList {
  std::vector<std::uint32_t> gaps;     ///< new vertices since the glued one before
  std::vector<std::uint32_t> targets;  ///< zigzag of the difference to the target before
};

/// Vertex of every manifold vertex, or nothing where none is glued, so that each is its own. Errors:
/// kInvalidStream [CONN-11].
Result<LargeVector<std::uint32_t>> glue_vertices(const GlueList& list, std::uint32_t manifold_count,
                                                 std::uint32_t vertex_count);

/// Replaces manifold vertices by vertices. `vertex`: as from glue_vertices().
void renumber(std::span<std::uint32_t> manifold, std::span<const std::uint32_t> vertex);

/// The faces of `border` over the mesh's vertices. `starts`: first manifold vertex of every component;
/// `vertex`: as from glue_vertices().
Connectivity glued(Border& border, std::vector<std::uint32_t> starts, std::span<const std::uint32_t> vertex);

/// Reads what write_gluing() wrote. Returns the same as glue_vertices(), or arbitrary numbers if the
/// reader failed. Errors: kInvalidStream [CONN-11, CONN-14].
Result<LargeVector<std::uint32_t>> read_gluing(CompactReader& reader, std::span<const std::uint32_t> faces,
                                               std::uint32_t manifold_count, std::uint32_t vertex_count);

}  // namespace deltamesh
