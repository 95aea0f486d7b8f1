// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Positions of a mesh to be coded as a request asks, by the coder that it asks for or that suits it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "deltamesh/encode.h"
#include "deltamesh/result.h"
#include "encoder/coded_geometry.h"
#include "encoder/lazy_graph.h"
#include "topology/mesh_edges.h"

namespace deltamesh {

/// The welded mesh in coding order, and the stream around its geometry.
struct GeometryTask {
  const EncodeOptions& options;
  std::span<const std::uint32_t> triangles;
  const LazyGraph& graph;
  const MeshEdges& edges;
  const std::vector<Vec3>& positions;
  const StreamFrame& frame;
  const AttributeBytes& attribute_bytes;  ///< may be empty: the same for all geometries
};

/// Errors: kUnmetRequest; kInvalidStream where the stream would break a rule, by what the positions are.
Result<GeometryChoice> code_geometry(const GeometryTask& task);

}  // namespace deltamesh
