// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <utility>

#include "connectivity/plain/topology.h"
#include "encoder/coded_topology.h"
#include "topology/adjacency.h"

namespace deltamesh {
namespace {

/// Corners 0 of the input's faces in their order.
std::vector<std::uint32_t> corners_in_order(std::size_t faces) {
  std::vector<std::uint32_t> corners(faces);
  for (std::size_t f = 0; f < faces; ++f) corners[f] = static_cast<std::uint32_t>(3 * f);
  return corners;
}

/// Items of `corners` rotated so that each face starts at its corner; `triangles`: m x 3.
std::vector<std::uint32_t> turned(std::span<const std::uint32_t> triangles,
                                  std::span<const std::uint32_t> corners) {
  std::vector<std::uint32_t> result;
  result.reserve(triangles.size());
  for (const std::uint32_t corner : corners)
    for (std::uint32_t k = 0; k < 3; ++k) result.push_back(triangles[corner - corner % 3 + (corner + k) % 3]);
  return result;
}

/// Numbers things by first appearance.
class Numbering {
 public:
  explicit Numbering(std::size_t things) : number_(things, kDropped) {}

  /// Returns whether it is new.
  bool add(std::uint32_t thing) {
    if (number_[thing] != kDropped) return false;
    number_[thing] = count_++;
    return true;
  }
  std::uint32_t of(std::uint32_t thing) const noexcept { return number_[thing]; }

 private:
  std::vector<std::uint32_t> number_;
  std::uint32_t count_ = 0;
};

/// The input vertices that are coded: in the input's order, or by first use and then those of no face.
std::vector<std::uint32_t> order_vertices(std::span<const std::uint32_t> triangles,
                                          const std::vector<std::uint8_t>& referenced,
                                          bool keeps_unreferenced, bool keep_order) {
  std::vector<std::uint32_t> order;
  if (!keep_order) {
    Numbering numbers(referenced.size());
    for (const std::uint32_t v : triangles)
      if (numbers.add(v)) order.push_back(v);
  }
  for (std::uint32_t v = 0; v < referenced.size(); ++v)
    if (referenced[v] != 0 ? keep_order : keeps_unreferenced) order.push_back(v);
  return order;
}

}  // namespace

CodedTopology code_plain_topology(const MeshView& mesh, bool keep_unreferenced, bool keep_order) {
  CodedTopology topology;
  const WeldedMesh welded = weld_mesh(mesh, keep_unreferenced, topology);
  const auto geometric_count = static_cast<std::uint32_t>(welded.representative.size());
  const auto corners =
      keep_order ? corners_in_order(mesh.triangle_count()) : walk_faces(welded.triangles, geometric_count);

  const auto input_triangles = turned(mesh.triangles, corners);
  std::vector<std::uint32_t> order =
      order_vertices(input_triangles, welded.referenced, keep_unreferenced, keep_order);
  Numbering vertices(welded.referenced.size());
  Numbering geometric(geometric_count);
  std::vector<std::uint32_t> geometric_of;
  for (const std::uint32_t input : order) {
    vertices.add(input);
    const std::uint32_t g = welded.geometric.empty() ? input : welded.geometric[input];
    if (geometric.add(g)) topology.geometric_input.push_back(input);
    geometric_of.push_back(geometric.of(g));
  }
  std::vector<std::uint32_t> triangles;
  triangles.reserve(input_triangles.size());
  for (const std::uint32_t input : input_triangles) triangles.push_back(vertices.of(input));

  CodedConnectivity& connectivity = topology.connectivity;
  connectivity.payload = write_plain_faces(triangles);
  for (const std::uint32_t corner : corners) {
    connectivity.face_order.push_back(corner / 3);
    connectivity.face_rotation.push_back(static_cast<std::uint8_t>(corner % 3));
  }
  topology.has_seams = welded.has_seams;
  if (welded.has_seams) {
    for (const std::uint32_t v : triangles) connectivity.triangles.push_back(geometric_of[v]);
    topology.seams.payload = write_plain_seams(geometric_of);
    topology.seams.split = {.triangles = std::move(triangles), .geometric = std::move(geometric_of)};
    topology.seams.vertex_order = std::move(order);
  } else {
    connectivity.triangles = std::move(triangles);
  }
  connectivity.components = count_components(connectivity.triangles, geometric_count);
  return topology;
}

}  // namespace deltamesh
