// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "support/coding_order.h"

#include <algorithm>

#include "base/try.h"
#include "deltamesh/io.h"
#include "encoder/coded_topology.h"

namespace deltamesh::bench {

WeldedMesh in_coding_order(const MeshView& mesh) {
  CodedTopology topology = code_topology(mesh, false);
  WeldedMesh coded;
  for (const std::uint32_t vertex : topology.geometric_input) {
    const float* p = mesh.positions.data() + 3 * std::size_t{vertex};
    const Vec3 position{p[0], p[1], p[2]};
    if (coded.positions.empty()) coded.box = {position, position};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      coded.box.min[axis] = std::min(coded.box.min[axis], position[axis]);
      coded.box.max[axis] = std::max(coded.box.max[axis], position[axis]);
    }
    coded.positions.push_back(position);
  }
  coded.triangles = std::move(topology.connectivity.triangles);
  coded.graph = build_adjacency(coded.triangles, topology.geometric_count());
  coded.components = find_components(coded.graph);
  return coded;
}

Result<WeldedMesh> load_in_coding_order(const std::string& path) {
  DELTAMESH_TRY(const Imported imported, read_mesh_file(path));
  return in_coding_order(imported.mesh);
}

}  // namespace deltamesh::bench
