// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <array>
#include <cstddef>
#include <utility>

#include "base/byte_writer.h"
#include "connectivity/connectivity.h"
#include "connectivity/gluing.h"
#include "connectivity/mesh_guide.h"
#include "connectivity/zipper.h"
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

using Faces = std::vector<std::uint32_t>;

/// The compact form of all faces in one walk [CONN-12 to CONN-14]; `faces` becomes theirs, over manifold
/// vertices.
std::vector<std::byte> write_whole(MeshGuide& guide, Faces& faces) {
  CompactWriter writer;
  Border border(guide.face_count());
  guide.walk(border, writer);
  faces = border.take_faces();
  if (faces.empty()) return {};
  write_compact_gluing(writer, {}, faces, guide.vertices().coded());
  return writer.finish();
}

/// The same in halves [CONN-15, CONN-16].
std::vector<std::byte> write_halves(MeshGuide& guide, Faces& faces) {
  std::array<CompactWriter, 2> writers;
  guide.cut();
  Border first(first_half_of(guide.face_count()));
  guide.walk(first, writers[0]);
  Border second(guide.face_count() - first_half_of(guide.face_count()), first.vertex_count());
  guide.walk(second, writers[1]);
  const std::vector<std::byte> first_ops = writers[0].finish();

  const std::vector<Zip> zips = find_zips(first, second, guide.vertices().coded());
  write_zips(writers[1], zips, first, second);
  const auto zipped = close_zips(zips, first, second);

  faces = first.take_faces();
  const std::span<const std::uint32_t> others = second.faces();
  faces.insert(faces.end(), others.begin(), others.end());
  write_compact_gluing(writers[1], zipped->vertices, faces, guide.vertices().coded());

  ByteWriter out;
  out.write(std::uint64_t{first_ops.size()});
  out.write(first.vertex_count());
  out.write_bytes(first_ops);
  out.write_bytes(writers[1].finish());
  return out.take();
}

}  // namespace

CodedConnectivity write_connectivity(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count,
                                     PayloadForms forms, Halving halving) {
  const auto face_count = static_cast<std::uint32_t>(triangles.size() / 3);
  MeshGuide guide(triangles, vertex_count, forms);
  const bool has_halves = face_count > 0 && is_halved(face_count, halving);
  CodedConnectivity coded;
  coded.compact = (has_halves ? write_halves : write_whole)(guide, coded.triangles);
  if (forms == PayloadForms::kBoth && face_count > 0)
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
