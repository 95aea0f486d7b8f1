// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "measure/face_graph.h"

#include "measure/surface.h"
#include "topology/weld.h"

namespace deltamesh {

FaceGraph::FaceGraph(const MeshView& mesh, const std::array<double, 3>& origin)
    : positions(positions_relative_to(origin, mesh)),
      vertices(mesh.triangles.begin(), mesh.triangles.end()),
      real_faces(mesh.triangle_count()) {
  std::vector<std::uint8_t> used(positions.size());
  for (const std::uint32_t v : vertices) used[v] = 1;
  for (std::uint32_t v = 0; v < used.size(); ++v)
    if (used[v] == 0) vertices.insert(vertices.end(), 3, v);
  std::fill(used.begin(), used.end(), std::uint8_t{1});
  const Weld weld = weld_by_position(mesh.positions, used);
  for (const std::uint32_t v : weld.representative) welded_positions.push_back(positions[v]);
  corners.resize(vertices.size());
  for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = weld.geometric[vertices[i]];

  // A face stands once around each of its different corners.
  const auto visit = [this](auto add) {
    for (std::size_t f = 0; f < face_count(); ++f)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t* const face = &corners[3 * f];
        if (std::find(face, face + k, face[k]) == face + k) add(face[k], static_cast<std::uint32_t>(f));
      }
  };
  first_.resize(welded_positions.size() + 1);
  visit([this](std::uint32_t v, std::uint32_t) { ++first_[v + 1]; });
  for (std::size_t v = 0; v + 1 < first_.size(); ++v) first_[v + 1] += first_[v];
  faces_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  visit([&](std::uint32_t v, std::uint32_t face) { faces_[next[v]++] = face; });
}

double FaceGraph::longest_edge(std::uint32_t face) const noexcept {
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    longest = std::max(longest, length(at(face, (k + 1) % 3) - at(face, k)));
  return longest;
}

std::span<const std::uint32_t> FaceGraph::around(std::uint32_t welded) const noexcept {
  const std::size_t count = first_[welded + 1] - first_[welded];
  return std::span(faces_).subspan(first_[welded], std::min(count, kMostLooked));
}

FacesAcross FaceGraph::across(std::uint32_t face, std::size_t corner) const noexcept {
  FacesAcross found;
  const std::size_t from = 3 * std::size_t{face} + corner;
  const std::size_t to = 3 * std::size_t{face} + (corner + 1) % 3;
  if (vertices[from] == vertices[to]) return found;
  // Where `ends` has the edge, going around `other`.
  const auto add = [&](const std::vector<std::uint32_t>& ends, std::uint32_t other, bool shared) {
    const std::uint32_t* const of = &ends[3 * std::size_t{other}];
    for (std::size_t k = 0; k < 3; ++k) {
      const bool same_way = of[k] == ends[from] && of[(k + 1) % 3] == ends[to];
      if (!same_way && !(of[k] == ends[to] && of[(k + 1) % 3] == ends[from])) continue;
      if (found.size < FacesAcross::kMost)
        found.faces[found.size++] = {
            .face = other, .corner = static_cast<std::uint8_t>(k), .same_way = same_way, .shared = shared};
      return true;
    }
    return false;
  };
  const std::span<const std::uint32_t> a = around(corners[from]);
  const std::span<const std::uint32_t> b = around(corners[to]);
  for (const std::uint32_t other : a.size() < b.size() ? a : b) {
    if (other == face || add(vertices, other, true)) continue;
    if (corners[from] != corners[to]) add(corners, other, false);
  }
  return found;
}

}  // namespace deltamesh
