// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "encoder/topology_chunks.h"

#include <utility>
#include <vector>

#include "connectivity/groups/groups.h"
#include "connectivity/plain/topology.h"
#include "format/chunk/tags.h"

namespace deltamesh {
namespace {

std::vector<std::byte> code_face_groups(const MeshView& mesh, const CodedTopology& topology, bool is_plain) {
  std::vector<std::uint32_t> groups;
  groups.reserve(mesh.face_groups.size());
  for (const std::uint32_t face : topology.connectivity.face_order) groups.push_back(mesh.face_groups[face]);
  if (is_plain) return write_plain_groups(groups);
  return write_face_groups(std::move(groups), topology.triangles(), topology.vertex_count());
}

}  // namespace

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
