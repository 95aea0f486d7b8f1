// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/byte_writer.h"
#include "base/numbers/zigzag.h"
#include "connectivity/faces/faces.h"
#include "connectivity/faces/glue_coder.h"
#include "connectivity/faces/gluing.h"
#include "connectivity/faces/mesh_guide.h"
#include "entropy/coder/writer.h"
#include "entropy/planes.h"

namespace deltamesh {
namespace {

/// `vertex`: as from glue_vertices().
GlueList list_glued(std::span<const std::uint32_t> vertex) {
  GlueList list;
  std::uint32_t fresh = 0;
  std::uint32_t gap_begin = 0;
  std::uint32_t last_target = 0;
  for (std::uint32_t m = 0; m < vertex.size(); ++m) {
    if (vertex[m] == fresh) {
      ++fresh;
    } else {
      list.gaps.push_back(fresh - std::exchange(gap_begin, fresh));
      list.targets.push_back(
          zigzag(static_cast<std::int32_t>(vertex[m] - std::exchange(last_target, vertex[m]))));
    }
  }
  return list;
}

/// The gluing by the compact coder: the list's length, then the list itself, or where it is long the vertices
/// one by one [CONN-13, CONN-14]. `faces`: manifold vertices, three each; `vertex`: as from
/// glue_vertices().
void write_compact_gluing(CompactWriter& writer, std::span<const std::uint32_t> faces,
                          std::vector<std::uint32_t> vertex) {
  const GlueList list = list_glued(vertex);
  NumberModel counts;
  writer.number(static_cast<std::uint32_t>(list.gaps.size()), counts);
  if (is_dense(list.gaps.size(), vertex.size())) {
    GlueCoder(writer, faces, vertex.size()).code(vertex, [] { return false; });
    return;
  }
  NumberModel gaps;
  NumberModel targets;
  for (std::size_t i = 0; i < list.gaps.size(); ++i) {
    writer.number(list.gaps[i], gaps);
    writer.number(list.targets[i], targets);
  }
}

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
