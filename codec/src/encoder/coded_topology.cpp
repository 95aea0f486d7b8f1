// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "encoder/coded_topology.h"

#include <utility>

#include "base/memory/large_vector.h"
#include "connectivity/groups/groups.h"
#include "connectivity/order/order.h"
#include "connectivity/plain/topology.h"
#include "format/chunk/tags.h"
#include "topology/weld.h"

namespace deltamesh {
namespace {

/// A flag for every vertex.
std::vector<std::uint8_t> find_referenced(const MeshView& mesh) {
  std::vector<std::uint8_t> referenced(mesh.vertex_count());
  for (const std::uint32_t v : mesh.triangles) referenced[v] = 1;
  return referenced;
}

/// The input vertex at every corner of the coded faces.
std::vector<std::uint32_t> corner_vertices(const MeshView& mesh, const CodedConnectivity& coded) {
  std::vector<std::uint32_t> corners(mesh.triangles.size());
  for (std::size_t f = 0; f < coded.face_order.size(); ++f) {
    const std::size_t face = 3 * std::size_t{coded.face_order[f]};
    for (std::size_t c = 0; c < 3; ++c)
      corners[3 * f + c] = mesh.triangles[face + (coded.face_rotation[f] + c) % 3];
  }
  return corners;
}

CodedSeams seams_of(const MeshView& mesh, const CodedTopology& topology,
                    const std::vector<std::uint8_t>& referenced) {
  std::vector<std::uint32_t> lone_vertices;
  for (const std::uint32_t input : topology.geometric_input)
    if (referenced[input] == 0) lone_vertices.push_back(input);
  return write_seams(topology.connectivity.triangles, topology.geometric_count(),
                     corner_vertices(mesh, topology.connectivity), lone_vertices);
}

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

std::vector<std::byte> code_face_groups(const MeshView& mesh, const CodedTopology& topology, bool is_plain) {
  std::vector<std::uint32_t> groups;
  groups.reserve(mesh.face_groups.size());
  for (const std::uint32_t face : topology.connectivity.face_order) groups.push_back(mesh.face_groups[face]);
  if (is_plain) return write_plain_groups(groups);
  return write_face_groups(std::move(groups), topology.triangles(), topology.vertex_count());
}

/// Restores the input's order (without dropped vertices). `input_vertices`: of the mesh.
MeshOrder original_order(const CodedTopology& topology, std::size_t input_vertices) {
  std::vector<std::uint32_t> kept(input_vertices, kDropped);
  for (const std::uint32_t v : topology.vertex_order()) kept[v] = 0;
  std::uint32_t next = 0;
  for (std::uint32_t& place : kept) {
    if (place != kDropped) place = next++;
  }
  MeshOrder order;
  order.vertices.reserve(next);
  for (const std::uint32_t v : topology.vertex_order()) order.vertices.push_back(kept[v]);
  order.faces = topology.connectivity.face_order;
  order.rotation = topology.connectivity.face_rotation;
  return order;
}

}  // namespace

WeldedMesh weld_mesh(const MeshView& mesh, bool keep_unreferenced, CodedTopology& topology) {
  WeldedMesh welded;
  welded.referenced = find_referenced(mesh);
  const std::vector<std::uint8_t>& referenced = welded.referenced;
  for (const std::uint8_t flag : referenced) topology.unreferenced += flag == 0;
  topology.unreferenced_kept = keep_unreferenced ? topology.unreferenced : 0;
  const bool drops = topology.unreferenced > topology.unreferenced_kept;
  Weld weld = weld_by_position(mesh.positions, referenced);
  welded.has_seams = weld.representative.size() < referenced.size();
  if (!welded.has_seams && !drops) {
    welded.triangles = mesh.triangles;
    welded.representative = std::move(weld.representative);
    return welded;
  }
  std::vector<std::uint32_t> number(weld.representative.size(), kDropped);
  for (std::uint32_t g = 0; g < number.size(); ++g) {
    if (drops && referenced[weld.representative[g]] == 0) continue;
    number[g] = static_cast<std::uint32_t>(welded.representative.size());
    welded.representative.push_back(weld.representative[g]);
  }
  welded.geometric = std::move(weld.geometric);
  for (std::uint32_t& g : welded.geometric) g = number[g];
  welded.renumbered.reserve(mesh.triangles.size());
  for (const std::uint32_t v : mesh.triangles) welded.renumbered.push_back(welded.geometric[v]);
  welded.triangles = welded.renumbered;
  return welded;
}

CodedTopology code_topology(const MeshView& mesh, bool keep_unreferenced, const OpModels* start) {
  CodedTopology topology;
  const WeldedMesh welded = weld_mesh(mesh, keep_unreferenced, topology);
  const auto geometric_count = static_cast<std::uint32_t>(welded.representative.size());
  topology.connectivity = write_connectivity(welded.triangles, geometric_count, start);

  topology.geometric_input.reserve(geometric_count);
  for (const std::uint32_t g : topology.connectivity.vertex_order)
    topology.geometric_input.push_back(welded.representative[g]);
  topology.has_seams = welded.has_seams;
  if (welded.has_seams) topology.seams = seams_of(mesh, topology, welded.referenced);
  return topology;
}

CodedTopology in_grid_order(const MeshView& mesh, const CodedTopology& topology, const CodedGrid& grid) {
  CodedTopology ordered;
  ordered.unreferenced = topology.unreferenced;
  ordered.unreferenced_kept = topology.unreferenced_kept;
  ordered.has_seams = topology.has_seams;
  const CodedConnectivity& before = topology.connectivity;
  CodedConnectivity& coded = ordered.connectivity;
  coded.components = before.components;
  coded.triangles = grid.triangles;
  for (std::size_t f = 0; f < grid.face_order.size(); ++f) {
    const std::uint32_t face = grid.face_order[f];
    coded.face_order.push_back(before.face_order[face]);
    coded.face_rotation.push_back(
        static_cast<std::uint8_t>((before.face_rotation[face] + grid.face_rotation[f]) % 3));
  }
  for (const std::uint32_t v : grid.vertex_order) {
    coded.vertex_order.push_back(before.vertex_order[v]);
    ordered.geometric_input.push_back(topology.geometric_input[v]);
  }
  if (ordered.has_seams) ordered.seams = seams_of(mesh, ordered, find_referenced(mesh));
  return ordered;
}

SourceGeometry source_geometry(const MeshView& mesh, const CodedTopology& topology) {
  return {gather_positions(mesh, topology.geometric_input), edges_of(topology)};
}

TopologyChunks code_topology_chunks(const MeshView& mesh, const EncodeOptions& options,
                                    const CodedTopology& topology) {
  const ChunkList none(options.profile, options.effort);
  TopologyChunks chunks{none, none, none};
  chunks.faces.add(kTagConnectivity, topology.connectivity.payload);
  chunks.splits.add(kTagSeams, topology.seams.payload);
  if (!mesh.face_groups.empty())
    chunks.splits.add(kTagFaceGroups, code_face_groups(mesh, topology, none.is_plain()));
  if (options.keep_order && !none.is_plain())
    chunks.order.add(kTagOrder,
                     write_order(original_order(topology, mesh.vertex_count()), topology.triangles()));
  return chunks;
}

}  // namespace deltamesh
