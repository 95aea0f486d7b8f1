// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From the input's faces to the coded order of vertices and faces, and to chunks: drop, weld, code the
// connectivity, split at seams.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "connectivity/faces/faces.h"
#include "connectivity/seams/seams.h"
#include "deltamesh/encode.h"
#include "deltamesh/mesh.h"
#include "entropy/chunk_list.h"
#include "grid/grid.h"
#include "topology/source_geometry.h"

namespace deltamesh {

inline constexpr std::uint32_t kDropped = 0xffffffff;

/// The input's faces over vertices of different positions, without vertices that are dropped.
struct WeldedMesh {
  std::vector<std::uint8_t> referenced;  ///< a flag for every input vertex
  /// Geometric vertex of every input vertex, or kDropped; empty where all are kept, each alone.
  std::vector<std::uint32_t> geometric;
  std::vector<std::uint32_t> renumbered;      ///< likewise
  std::span<const std::uint32_t> triangles;   ///< the input's, or those that are renumbered
  std::vector<std::uint32_t> representative;  ///< input vertex of every geometric vertex
  bool has_seams = false;
};

struct CodedTopology {
  std::uint64_t unreferenced = 0;  ///< input vertices that no face uses
  std::uint64_t unreferenced_kept =
      0;                           ///< as many of them as are coded; last of all but in the input's order
  CodedConnectivity connectivity;  ///< over geometric vertices
  bool has_seams = false;          ///< some vertices were welded
  CodedSeams seams;                ///< over the vertices that are kept; empty without seams
  std::vector<std::uint32_t> geometric_input;  ///< an input vertex of every coded geometric vertex

  /// m x 3, over the vertices of the decoded mesh.
  std::span<const std::uint32_t> triangles() const noexcept {
    return has_seams ? seams.split.triangles : connectivity.triangles;
  }
  /// Input vertex of every decoded vertex, in coding order.
  const std::vector<std::uint32_t>& vertex_order() const noexcept {
    return has_seams ? seams.vertex_order : geometric_input;
  }
  std::uint32_t geometric_count() const noexcept {
    return static_cast<std::uint32_t>(geometric_input.size());
  }
  std::uint32_t vertex_count() const noexcept { return static_cast<std::uint32_t>(vertex_order().size()); }
};

/// Without vertices that no face uses, unless they are kept; `topology` gets their numbers. The mesh must
/// outlive the result.
WeldedMesh weld_mesh(const MeshView& mesh, bool keep_unreferenced, CodedTopology& topology);

/// `mesh` has passed check_mesh. `start`: as write_connectivity() has it. O(n + m) expected.
CodedTopology code_topology(const MeshView& mesh, bool keep_unreferenced, const OpModels* start = nullptr);

/// The same in the plain form, whose vertices and faces are in the input's order or in one that takes few
/// bytes.
CodedTopology code_plain_topology(const MeshView& mesh, bool keep_unreferenced, bool keep_order);

/// `topology` of `mesh` in the order of `grid`, whose vertices and faces are the topology's geometric ones.
/// It has no payload of faces.
CodedTopology in_grid_order(const MeshView& mesh, const CodedTopology& topology, const CodedGrid& grid);

/// What geometry coders get; `topology` must outlive it.
SourceGeometry source_geometry(const MeshView& mesh, const CodedTopology& topology);

/// A coded topology as chunks.
struct TopologyChunks {
  ChunkList faces;   ///< CONN; empty where the geometry has the faces
  ChunkList splits;  ///< seams and groups
  ChunkList order;   ///< the input's, if it is kept; plain payloads are in that order

  /// Of all but the faces.
  std::uint64_t other_bytes() const noexcept { return splits.bytes() + order.bytes(); }
};

/// `topology`: of `mesh`. O(n + m).
TopologyChunks code_topology_chunks(const MeshView& mesh, const EncodeOptions& options,
                                    const CodedTopology& topology);

}  // namespace deltamesh
