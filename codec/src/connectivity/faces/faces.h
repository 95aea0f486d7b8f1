// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// CONN: the faces of any triangle soup over its geometric vertices, lossless up to the order of vertices and
// faces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/memory/large_vector.h"
#include "deltamesh/result.h"
#include "entropy/coder/learning.h"
#include "entropy/payload.h"
#include "topology/vertex_runs.h"

namespace deltamesh {

struct OpModels;

/// Which forms of a payload to write.
enum class PayloadForms : std::uint8_t { kBoth, kCompact };

struct CodedConnectivity {
  std::vector<std::byte> payload;        ///< plain; empty where not asked for
  std::vector<std::byte> compact;        ///< the same in the compact form
  std::vector<std::uint32_t> triangles;  ///< m x 3: what read_connectivity will return
  std::vector<std::uint32_t>
      vertex_order;  ///< n: input vertex of every coded vertex; unreferenced ones last, ascending
  std::vector<std::uint32_t> face_order;  ///< m: input face of every coded face
  std::vector<std::uint8_t>
      face_rotation;  ///< m: which corner (0 to 2) of the input face is the coded face's corner 0
  /// Parts of the mesh that share no vertex; an unreferenced vertex is one.
  std::uint32_t components = 0;
  /// m: bit k of a coded face stands for the edge from its corner k to its next; of all that stand for the
  /// same edge, whichever its direction, one is set. Empty where a face has a vertex twice.
  std::vector<std::uint8_t> new_edges;
};

/// `triangles`: m x 3 indices below `vertex_count`; anything goes: non-manifold, duplicate, degenerate,
/// either orientation. `start`: of the compact form; null for fresh models. O(n + m) expected, no recursion.
CodedConnectivity write_connectivity(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count,
                                     PayloadForms forms = PayloadForms::kBoth,
                                     const OpModels* start = nullptr);

struct Connectivity {
  std::vector<std::uint32_t> triangles;  ///< m x 3 vertices
  /// Edges of a face that have none in the other direction, but for what gluing brought together.
  LargeVector<DirectedEdge> open_edges;
  VertexRuns runs;  ///< of connected vertices
};

/// Indices are below `vertex_count`. The caller has checked both counts against its limits;
/// they are checked here against the bytes present before anything of their size is allocated. Errors:
/// kTruncated, kInvalidStream [CONN-*].
Result<Connectivity> read_connectivity(Payload payload, std::uint32_t vertex_count,
                                       std::uint32_t triangle_count, const Learning<OpModels>& learning = {});

}  // namespace deltamesh
