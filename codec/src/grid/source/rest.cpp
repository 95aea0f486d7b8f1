// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "grid/source/rest.h"

#include <algorithm>

#include "positions/blend/fit.h"
#include "positions/guess_trial.h"

namespace deltamesh::grid {

SourceRest::SourceRest(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count,
                       const SourceCubes& source)
    : triangles_(triangles), faces_(source.left_faces()) {
  std::vector<std::uint8_t> is_of_rest(vertex_count, 1);
  std::size_t next = 0;
  for (std::uint32_t face = 0; 3 * std::size_t{face} < triangles.size(); ++face) {
    if (next < faces_.size() && faces_[next] == face) {
      ++next;
    } else {
      for (std::size_t c = 0; c < 3; ++c) is_of_rest[triangles[3 * std::size_t{face} + c]] = 0;
    }
  }
  for (const std::uint32_t face : faces_)
    for (std::size_t c = 0; c < 3; ++c) is_of_rest[triangles[3 * std::size_t{face} + c]] = 1;
  for (std::uint32_t v = 0; v < vertex_count; ++v)
    if (is_of_rest[v] != 0) vertices_.push_back(v);
}

/// By their first vertices, so that faces side by side are coded one soon after the other.
void SourceRest::sort_faces(std::span<const std::uint32_t> numbers) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> order;
  order.reserve(faces_.size());
  for (const std::uint32_t face : faces_) {
    const std::uint32_t* const corners = &triangles_[3 * std::size_t{face}];
    order.emplace_back(std::min({numbers[corners[0]], numbers[corners[1]], numbers[corners[2]]}), face);
  }
  std::sort(order.begin(), order.end());
  for (std::size_t f = 0; f < order.size(); ++f) faces_[f] = order[f].second;
}

CodedConnectivity SourceRest::write_faces(std::size_t vertex_count) const {
  std::vector<std::uint32_t> local(vertex_count);
  for (std::uint32_t v = 0; v < vertices_.size(); ++v) local[vertices_[v]] = v;
  std::vector<std::uint32_t> corners;
  corners.reserve(3 * faces_.size());
  for (const std::uint32_t face : faces_)
    for (std::size_t c = 0; c < 3; ++c) corners.push_back(local[triangles_[3 * std::size_t{face} + c]]);
  return write_connectivity(corners, static_cast<std::uint32_t>(vertices_.size()));
}

void SourceRest::write(CompactWriter& writer, RestModels& models, const VertexFinder& finder,
                       std::span<const Cell> cells, const PredictiveParameters& parameters,
                       CodedGrid& coded) {
  std::vector<std::uint32_t> in_surface(cells.size(), kNoVertex);
  for (std::uint32_t v = 0; v < coded.vertex_order.size(); ++v) in_surface[coded.vertex_order[v]] = v;
  sort_faces(in_surface);
  const CodedConnectivity faces = write_faces(cells.size());
  coded.payloads.rest_faces = faces.payload;

  std::vector<std::uint32_t> numbers;
  std::vector<Cell> places;
  for (const std::uint32_t local : faces.vertex_order) {
    const std::uint32_t vertex = vertices_[local];
    const bool is_own = in_surface[vertex] == kNoVertex;
    numbers.push_back(is_own ? static_cast<std::uint32_t>(coded.vertex_order.size()) : in_surface[vertex]);
    if (is_own) coded.vertex_order.push_back(vertex);
    places.push_back(cells[vertex]);
  }
  const KnownFaces known({faces.triangles, size().vertices});
  RestForm form{.blends = fit_blends(known, places, BlendFit::kSquares)};
  form.guesses = guesses_pay(known, places, parameters.lattice.cells, form.blends);
  RestCoder(writer, models, known, finder, parameters.lattice.cells).code(form, numbers, places);

  for (const std::uint32_t v : faces.triangles) coded.triangles.push_back(numbers[v]);
  for (const std::uint32_t face : faces.face_order) coded.face_order.push_back(faces_[face]);
  coded.face_rotation.insert(coded.face_rotation.end(), faces.face_rotation.begin(),
                             faces.face_rotation.end());
  coded.rest_triangles = size().triangles;
}

}  // namespace deltamesh::grid
