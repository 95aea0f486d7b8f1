// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <cstddef>
#include <utility>

#include "base/byte_writer.h"
#include "connectivity/connectivity.h"
#include "connectivity/gluing_write.h"
#include "connectivity/mesh_guide.h"
#include "entropy/compact_writer.h"
#include "entropy/planes.h"

namespace deltamesh {
namespace {

std::vector<std::byte> write_payload(const MeshGuide& guide, const GlueList& glued) {
  ByteWriter out;
  for (std::size_t i = 0; i < kTokenStreams; ++i) out.write_varint(guide.tokens().stream(i).size());
  out.write_varint(guide.references().size());
  out.write_varint(guide.far_targets().size());
  out.write_varint(glued.gaps.size());
  for (std::size_t i = 0; i < kTokenStreams; ++i) out.write_bytes(guide.tokens().stream(i));
  out.write_bytes(guide.references());
  write_planes(out, guide.far_targets());
  write_planes(out, glued.gaps);
  write_planes(out, glued.targets);
  return out.take();
}

/// The compact form [CONN-12 to CONN-14]; `faces` becomes those of the traversal, over manifold vertices.
std::vector<std::byte> write_compact(MeshGuide& guide, const OpModels* start,
                                     std::vector<std::uint32_t>& faces) {
  CompactWriter writer;
  Border border(guide.face_count());
  guide.run(border, writer, start);
  faces = border.take_faces();
  if (faces.empty()) return {};
  write_compact_gluing(writer, faces, guide.vertices().coded());
  return writer.finish();
}

}  // namespace

CodedConnectivity write_connectivity(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count,
                                     PayloadForms forms, const OpModels* start) {
  MeshGuide guide(triangles, vertex_count, forms);
  CodedConnectivity coded;
  coded.compact = write_compact(guide, start, coded.triangles);
  if (forms == PayloadForms::kBoth && !triangles.empty())
    coded.payload = write_payload(guide, list_glued(guide.vertices().coded()));
  renumber(coded.triangles, guide.vertices().coded());
  coded.components = guide.vertices().count_components();
  coded.vertex_order = guide.vertices().take_order();
  coded.new_edges = guide.take_new_edges();
  coded.face_order = guide.take_face_order();
  coded.face_rotation = guide.take_face_rotation();
  return coded;
}

}  // namespace deltamesh
