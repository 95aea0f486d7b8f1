// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// SEAM: which corners of a geometric vertex share a vertex of the mesh. Absent where nothing was welded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/result.h"
#include "entropy/payload.h"

namespace deltamesh {

/// Faces over vertices, and what each vertex is a copy of. Vertices are numbered by geometric vertex, then by
/// copy, so that `geometric` never falls.
struct SplitVertices {
  std::vector<std::uint32_t> triangles;  ///< m x 3 vertex indices
  std::vector<std::uint32_t> geometric;  ///< geometric vertex of every vertex
};

struct CodedSeams {
  std::vector<std::byte> payload;           ///< empty where every geometric vertex has one copy
  std::vector<std::byte> compact;           ///< the same by the compact coder
  SplitVertices split;                      ///< what read_seams will return
  std::vector<std::uint32_t> vertex_order;  ///< input vertex of every coded vertex
};

/// `geometric_triangles`: m x 3, as coded; `corner_vertices`: m x 3, the input vertex at the same corner;
/// `lone_vertices`: input vertex of every geometric vertex that no face uses (those are the last geometric
/// vertices).
CodedSeams write_seams(std::span<const std::uint32_t> geometric_triangles, std::uint32_t geometric_count,
                       std::span<const std::uint32_t> corner_vertices,
                       std::span<const std::uint32_t> lone_vertices);

/// `vertex_count`: what the header declares, at least `geometric_count`. An empty payload stands for no
/// seams. Errors: kTruncated, kInvalidStream [SEAM-*].
Result<SplitVertices> read_seams(Payload payload, std::span<const std::uint32_t> geometric_triangles,
                                 std::uint32_t geometric_count, std::uint32_t vertex_count);

}  // namespace deltamesh
