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

/// CONN as decoded: faces over manifold vertices, and the vertex of the mesh for each of these.
struct ManifoldFaces {
  std::vector<std::uint32_t> triangles;  ///< m x 3
  LargeVector<DirectedEdge> open_edges;  ///< as Border's
  std::vector<std::uint32_t> starts;  ///< first vertex of every component, ascending, and the end of the last
  LargeVector<std::uint32_t> vertex;  ///< as from glue_vertices()
};

/// Moves faces and open edges out of `border`. `starts`: first manifold vertex of every component; `vertex`:
/// as from glue_vertices().
ManifoldFaces take_faces(Border& border, std::vector<std::uint32_t> starts,
                         LargeVector<std::uint32_t> vertex);

/// The faces over the mesh's vertices instead of manifold vertices.
Connectivity glued(ManifoldFaces faces);

/// Checks a list's length before anything of its size is allocated. Errors: kInvalidStream [CONN-11].
Result<void> check_glue_count(std::uint64_t count, std::uint32_t manifold_count, std::uint32_t vertex_count);

/// Reads what write_compact_gluing() wrote. Returns the same as glue_vertices(), or arbitrary numbers if the
/// reader failed. Errors: kInvalidStream [CONN-11, CONN-14].
Result<LargeVector<std::uint32_t>> read_compact_gluing(CompactReader& reader,
                                                       std::span<const std::uint32_t> faces,
                                                       std::uint32_t manifold_count,
                                                       std::uint32_t vertex_count);

}  // namespace deltamesh
