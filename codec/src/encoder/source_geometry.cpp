// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "encoder/source_geometry.h"

#include "base/memory/large_vector.h"

namespace deltamesh {
namespace {

std::vector<Vec3> gather_positions(const MeshView& mesh, const std::vector<std::uint32_t>& input_vertices) {
  std::vector<Vec3> positions;
  reserve_large(positions, input_vertices.size());
  for (const std::uint32_t v : input_vertices) {
    const float* p = mesh.positions.data() + 3 * std::size_t{v};
    positions.push_back({p[0], p[1], p[2]});
  }
  return positions;
}

/// All edges of the coded mesh, which the connectivity's writer has mostly met already.
MeshEdges edges_of(const CodedTopology& topology) {
  const CodedConnectivity& coded = topology.connectivity;
  const std::uint32_t count = topology.geometric_count();
  if (coded.new_edges.empty()) return find_edges(coded.triangles, count);
  MeshEdges edges{.triangles = coded.triangles, .visited = coded.new_edges};
  for (auto v = static_cast<std::uint32_t>(count - topology.unreferenced_kept); v < count; ++v)
    edges.lone_vertices.push_back(v);
  return edges;
}

}  // namespace

SourceGeometry::SourceGeometry(const MeshView& mesh, const CodedTopology& topology)
    : positions(gather_positions(mesh, topology.geometric_input)),
      box(Box::around(positions)),
      triangles(topology.connectivity.triangles),
      graph(triangles, topology.geometric_count()),
      edges(edges_of(topology)) {}

}  // namespace deltamesh
