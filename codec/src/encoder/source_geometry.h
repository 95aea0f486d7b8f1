// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Positions and faces of the welded mesh in coding order, as geometry coders get them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "deltamesh/mesh.h"
#include "encoder/coded_topology.h"
#include "encoder/lazy_graph.h"
#include "topology/mesh_edges.h"

namespace deltamesh {

/// Not for several threads at once. The topology must outlive it.
struct SourceGeometry {
  SourceGeometry(const MeshView& mesh, const CodedTopology& topology);

  std::vector<Vec3> positions;               ///< n, relative to the mesh's origin
  Box box;                                   ///< of `positions`; empty if there are none
  std::span<const std::uint32_t> triangles;  ///< m x 3
  LazyGraph graph;                           ///< of `triangles`
  MeshEdges edges;                           ///< likewise
};

}  // namespace deltamesh
