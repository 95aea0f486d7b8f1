// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "decoder/stream_faces.h"

#include <array>
#include <utility>

#include "base/try.h"
#include "connectivity/plain/topology.h"
#include "connectivity/seams/seams.h"
#include "entropy/expand_chunk.h"
#include "format/chunk/kinds.h"
#include "grid/grid.h"

namespace deltamesh {
namespace {

Result<void> check_components(const FileHeader& header, std::uint32_t count) {
  if (count == header.components) return {};
  return Error{.code = ErrorCode::kInvalidStream,
               .message = "the number of connected components differs from the header's",
               .rule = "HDR-7"};
}

/// What GRID, CONN and POSN hold together [GRD-*]: with the positions, which wait.
Result<void> read_grid_faces(const Container& container, const StreamLearning& learning,
                             const KnownMesh* known, StreamFaces& faces) {
  std::array<ExpandedChunk, kGridTags.size()> expanded;
  GridChunks chunks;
  for (std::size_t k = 0; k < chunks.size(); ++k) {
    DELTAMESH_TRY(expanded[k], expand_single(container, kGridTags[k]));
    chunks[k] = expanded[k].bytes();
  }
  const FileHeader& header = container.header();
  DELTAMESH_TRY(auto mesh, read_grid(chunks, header.predictive, header.geometric_vertices, header.triangles,
                                     learning.of_grid(), known));
  faces.triangles = std::move(mesh.triangles);
  faces.grid_positions = std::move(mesh.positions);
  faces.known = std::move(mesh.known);
  return {};
}

Result<void> read_connected_faces(const Container& container, const StreamLearning& learning,
                                  StreamFaces& faces) {
  const FileHeader& header = container.header();
  DELTAMESH_TRY(const auto connectivity, expand_single(container, kTagConnectivity));
  DELTAMESH_TRY(auto read, read_connectivity(connectivity.bytes(), header.geometric_vertices,
                                             header.triangles, learning.of_ops()));
  DELTAMESH_CHECK(check_components(header, read.runs.count(header.geometric_vertices)));
  faces.triangles = std::move(read.triangles);
  faces.open_edges = std::move(read.open_edges);
  faces.runs = std::move(read.runs);
  if (faces.triangles.capacity() / 5 > faces.triangles.size() / 4) faces.triangles.shrink_to_fit();
  return {};
}

}  // namespace

Result<StreamFaces> read_plain_stream_faces(const Container& container) {
  const FileHeader& header = container.header();
  StreamFaces faces;
  DELTAMESH_TRY(const auto connectivity, expand_single(container, kTagConnectivity));
  DELTAMESH_TRY(faces.triangles, read_plain_faces(connectivity.bytes(), header.triangles, header.vertices));
  DELTAMESH_TRY(const auto seams, expand_single(container, kTagSeams));
  DELTAMESH_TRY(faces.copies, read_plain_seams(seams.bytes(), header.geometric_vertices, header.vertices));
  if (faces.is_split()) {
    faces.split.reserve(faces.triangles.size());
    for (const std::uint32_t v : faces.triangles) faces.split.push_back(faces.copies[v]);
  }
  DELTAMESH_CHECK(check_components(header, count_components(faces.geometric(), header.geometric_vertices)));
  return faces;
}

Result<StreamFaces> read_stream_faces(const Container& container, const StreamLearning& learning,
                                      const KnownMesh* known) {
  const FileHeader& header = container.header();
  StreamFaces faces;
  DELTAMESH_CHECK(is_of_grid(header) ? read_grid_faces(container, learning, known, faces)
                                     : read_connected_faces(container, learning, faces));
  DELTAMESH_TRY(const auto seams, expand_single(container, kTagSeams));
  if (seams.bytes().empty() && header.vertices == header.geometric_vertices) return faces;
  DELTAMESH_TRY(auto split,
                read_seams(seams.bytes(), faces.triangles, header.geometric_vertices, header.vertices));
  faces.split = std::exchange(faces.triangles, std::move(split.triangles));
  faces.copies = std::move(split.geometric);
  return faces;
}

}  // namespace deltamesh
