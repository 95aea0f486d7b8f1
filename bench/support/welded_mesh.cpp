// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "support/welded_mesh.h"

#include <utility>

#include "base/try.h"
#include "connectivity/faces/faces.h"
#include "deltamesh/io.h"
#include "topology/weld.h"

namespace deltamesh::bench {
namespace {

Vec3 position_of(const MeshView& mesh, std::uint32_t vertex) {
  return {mesh.positions[3 * vertex], mesh.positions[3 * vertex + 1], mesh.positions[3 * vertex + 2]};
}

}  // namespace

WeldedMesh weld(const MeshView& mesh) {
  std::vector<std::uint8_t> used(mesh.vertex_count(), 0);
  for (const std::uint32_t vertex : mesh.triangles) used[vertex] = 1;
  const Weld welding = weld_by_position(mesh.positions, used);

  // Geometric vertices that a face uses, renumbered in order.
  std::vector<std::uint32_t> number(welding.representative.size(), 0);
  WeldedMesh welded;
  for (std::size_t g = 0; g < number.size(); ++g) {
    if (used[welding.representative[g]] == 0) continue;
    number[g] = static_cast<std::uint32_t>(welded.positions.size());
    welded.positions.push_back(position_of(mesh, welding.representative[g]));
  }
  welded.triangles.resize(mesh.triangles.size());
  for (std::size_t corner = 0; corner < welded.triangles.size(); ++corner)
    welded.triangles[corner] = number[welding.geometric[mesh.triangles[corner]]];
  welded.graph = build_adjacency(welded.triangles, static_cast<std::uint32_t>(welded.positions.size()));
  welded.components = find_components(welded.graph);
  welded.box = Box::around(welded.positions);
  return welded;
}

WeldedMesh in_coding_order(const WeldedMesh& welded) {
  const auto vertices = static_cast<std::uint32_t>(welded.positions.size());
  CodedConnectivity connectivity = write_connectivity(welded.triangles, vertices);
  WeldedMesh coded;
  for (const std::uint32_t v : connectivity.vertex_order) coded.positions.push_back(welded.positions[v]);
  coded.triangles = std::move(connectivity.triangles);
  coded.graph = build_adjacency(coded.triangles, vertices);
  coded.components = find_components(coded.graph);
  coded.box = welded.box;
  return coded;
}

Result<WeldedMesh> load_welded(const std::string& path) {
  DELTAMESH_TRY(const Imported imported, read_mesh_file(path));
  return weld(imported.mesh);
}

}  // namespace deltamesh::bench
