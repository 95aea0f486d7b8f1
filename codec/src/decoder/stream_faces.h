// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The faces of a stream, whichever chunks they are in.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/memory/large_vector.h"
#include "connectivity/faces/faces.h"
#include "decoder/stream_learning.h"
#include "deltamesh/result.h"
#include "format/container.h"
#include "grid/known/vertex.h"
#include "topology/adjacency.h"

namespace deltamesh {

struct StreamFaces {
  std::vector<std::uint32_t> triangles;  ///< m x 3, over the mesh's vertices
  std::vector<std::uint32_t> split;      ///< m x 3, over the geometric vertices; empty where seams split none
  std::vector<std::uint32_t> copies;     ///< geometric vertex of every vertex; likewise
  LargeVector<DirectedEdge> open_edges;  ///< of the geometric faces; empty in the plain form and of a grid
  VertexRuns runs;                       ///< of the geometric vertices; likewise
  std::vector<float> grid_positions;     ///< n x 3, of a grid's geometric vertices; else empty
  std::vector<std::uint32_t> known;      ///< n, likewise, beside a known mesh; else empty

  bool is_split() const noexcept { return !copies.empty(); }
  /// m x 3, over the geometric vertices.
  std::span<const std::uint32_t> geometric() const noexcept { return is_split() ? split : triangles; }
};

/// In the plain form, or in the compact one. Errors: kInvalidStream, kLimitExceeded.
Result<StreamFaces> read_plain_stream_faces(const Container& container);
Result<StreamFaces> read_stream_faces(const Container& container, const StreamLearning& learning,
                                      const KnownMesh* known);

}  // namespace deltamesh
