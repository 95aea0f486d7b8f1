// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The positions of a mesh, coded within a stream whose other chunks are known.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "deltamesh/encode.h"
#include "deltamesh/result.h"
#include "encoder/coded_geometry.h"
#include "encoder/coded_topology.h"
#include "encoder/lazy_graph.h"
#include "topology/mesh_edges.h"

namespace deltamesh {

/// Not for several threads at once. The arguments must outlive it.
class GeometryStage {
 public:
  GeometryStage(const MeshView& mesh, const CodedTopology& topology);

  const std::vector<Vec3>& positions() const noexcept { return positions_; }

  /// Sets box and components of the header.
  void describe(FileHeader& header) const;

  /// `attribute_bytes`: what attributes would take on these decoded positions, empty ones for a highpass
  /// geometry; may be empty where they take the same on all. Errors: kUnmetRequest, kInvalidMesh.
  Result<GeometryChoice> code(const EncodeOptions& options, const StreamFrame& frame,
                              const AttributeBytes& attribute_bytes = {}) const;

 private:
  const CodedTopology& topology_;
  std::vector<Vec3> positions_;
  LazyGraph graph_;
  MeshEdges edges_;
};

/// Sets the figures of `choice` in the header. Errors: kInvalidMesh where floats do not hold them.
Result<void> describe(const GeometryChoice& choice, FileHeader& header);

}  // namespace deltamesh
