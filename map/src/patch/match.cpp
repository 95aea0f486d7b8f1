// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "patch/match.h"

#include <algorithm>
#include <array>

#include "base/numbers/vec3.h"
#include "lattice/positions.h"
#include "patch/coder.h"
#include "patch/color_match.h"
#include "patch/row_lists.h"
#include "support/color_value.h"
#include "support/open_edges.h"

namespace deltamesh {
namespace {

/// Whether several vertices have the position.
std::vector<std::uint8_t> shared_positions(const Mesh& mesh) {
  std::vector<std::uint8_t> is_shared(mesh.vertex_count(), 0);
  RowLists lists(mesh.vertex_count());
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    const PositionBits bits = bits_of(mesh, v);
    for (std::uint32_t u = lists.first(row_hash(bits)); u != kNoRow; u = lists.next(u))
      if (bits_of(mesh, u) == bits) is_shared[u] = is_shared[v] = 1;
    lists.add(row_hash(bits), v);
  }
  return is_shared;
}

/// For every face and up to three others with which it has an edge in common.
std::vector<std::array<std::uint32_t, 3>> neighbors_of_faces(const Mesh& mesh) {
  const auto earlier = earlier_neighbors(mesh.triangles, mesh.vertex_count());
  auto neighbors = earlier;
  for (std::uint32_t f = 0; f < earlier.size(); ++f) {
    for (const std::uint32_t g : earlier[f]) {
      if (g == kNoFace) continue;
      const auto free = std::ranges::find(neighbors[g], kNoFace);
      if (free != neighbors[g].end()) *free = f;
    }
  }
  return neighbors;
}

class Matcher {
 public:
  Matcher(const MapPart& source, const BaseVersion& base, const MatchBounds& bounds)
      : source_(source), base_(base), bounds_(bounds), base_of_(source.mesh.vertex_count(), kNotJoined) {}

  PartMatch run() {
    match_vertices();
    keep_mean_error(source_.mesh, base_.part.mesh, bounds_.quality, base_of_);
    match_faces();
    smooth();
    while (drop_vertices_without_open_edges()) {
    }
    return result();
  }

 private:
  void match_vertices() {
    const auto source_border = border_by_vertex(source_);
    const auto base_border = border_by_vertex(base_.part);
    const NearRows rows(base_.sources, bounds_.max_error);
    const auto is_shared = shared_positions(source_.mesh);
    std::vector<std::uint32_t> taken(base_.part.mesh.vertex_count(), kNotJoined);
    for (std::uint32_t v = 0; v < base_of_.size(); ++v) {
      if (is_shared[v] != 0) continue;  // a position of vertices with several colours
      const float* const position = source_.mesh.positions.data() + 3 * std::size_t{v};
      const std::uint32_t near = rows.nearest(position);
      if (near == kNoRow || !is_good_enough(v, near, source_border) || source_border[v] != base_border[near])
        continue;
      if (const std::uint32_t other = taken[near]; other != kNotJoined) {
        const float* const place = base_.sources.data() + 3 * std::size_t{near};
        if (squared_distance(source_.mesh.positions.data() + 3 * std::size_t{other}, place) <=
            squared_distance(position, place))
          continue;
        base_of_[other] = kNotJoined;
      }
      base_of_[v] = near;
      taken[near] = v;
    }
  }

  static std::vector<BorderVertex> border_by_vertex(const MapPart& part) {
    std::vector<BorderVertex> border(part.mesh.vertex_count(), BorderVertex{.vertex = 0});
    for (const BorderVertex& vertex : part.border) {
      border[vertex.vertex] = vertex;
      border[vertex.vertex].vertex = 1;
    }
    return border;
  }

  bool is_good_enough(std::uint32_t v, std::uint32_t base, std::span<const BorderVertex> border) const {
    if (squared_distance(source_.mesh.positions.data() + 3 * std::size_t{v},
                         base_.part.mesh.positions.data() + 3 * std::size_t{base}) >
        bounds_.max_error * bounds_.max_error)
      return false;
    const bool is_border = border[v].vertex != 0;
    return keeps_colors(source_.mesh, v, base_.part.mesh, base, bounds_.quality, is_border);
  }

  void match_faces() {
    const auto face_at = [](const std::vector<std::uint32_t>& triangles, std::size_t f) {
      return std::array{triangles[3 * f], triangles[3 * f + 1], triangles[3 * f + 2]};
    };
    const auto& theirs = base_.part.mesh.triangles;
    RowLists faces(theirs.size() / 3);
    for (std::uint32_t f = 0; f < theirs.size() / 3; ++f) faces.add(row_hash(rotated(face_at(theirs, f))), f);
    std::vector<std::uint8_t> is_taken(theirs.size() / 3, 0);
    const auto& ours = source_.mesh.triangles;
    face_of_.assign(ours.size() / 3, kNotJoined);
    for (std::size_t f = 0; f < face_of_.size(); ++f) {
      auto face = face_at(ours, f);
      for (std::uint32_t& v : face) v = base_of_[v];
      if (std::ranges::find(face, kNotJoined) != face.end()) continue;
      face = rotated(face);
      std::uint32_t found = faces.first(row_hash(face));
      while (found != kNoRow && (is_taken[found] != 0 || rotated(face_at(theirs, found)) != face))
        found = faces.next(found);
      if (found == kNoRow) continue;
      face_of_[f] = found;
      is_taken[found] = 1;
    }
  }

  /// Beginning with the lowest vertex.
  static std::array<std::uint32_t, 3> rotated(std::array<std::uint32_t, 3> face) noexcept {
    std::rotate(face.begin(), std::ranges::min_element(face), face.end());
    return face;
  }

  /// Gives the new faces shorter borders: what is joined is coded twice.
  void smooth() {
    const auto neighbors = neighbors_of_faces(source_.mesh);
    std::vector<std::uint32_t> list;
    for (std::uint32_t f = 0; f < face_of_.size(); ++f) list.push_back(f);
    while (!list.empty()) {
      const std::uint32_t f = list.back();
      list.pop_back();
      if (face_of_[f] == kNotJoined || std::ranges::count_if(neighbors[f], [&](std::uint32_t g) {
                                         return g != kNoFace && face_of_[g] == kNotJoined;
                                       }) < 2)
        continue;
      face_of_[f] = kNotJoined;
      for (const std::uint32_t g : neighbors[f])
        if (g != kNoFace) list.push_back(g);
    }
  }

  /// What vertices are joined by.
  bool drop_vertices_without_open_edges() {
    std::array<std::vector<std::uint32_t>, 2> triangles;  // new ones, those that stay
    std::array<std::vector<std::uint8_t>, 2> uses;
    for (auto& use : uses) use.assign(base_of_.size(), 0);
    for (std::size_t f = 0; f < face_of_.size(); ++f) {
      const std::size_t kind = face_of_[f] != kNotJoined ? 1 : 0;
      for (std::size_t c = 0; c < 3; ++c) {
        const std::uint32_t v = source_.mesh.triangles[3 * f + c];
        triangles[kind].push_back(v);
        uses[kind][v] = 1;
      }
    }
    const OpenEdges fresh(triangles[0], base_of_.size());
    const OpenEdges staying(triangles[1], base_of_.size());
    bool any = false;
    std::vector<std::uint8_t> is_bad(base_of_.size(), 0);
    for (std::uint32_t v = 0; v < base_of_.size(); ++v) {
      if (uses[0][v] == 0 || uses[1][v] == 0 || (!fresh.of(v).empty() && !staying.of(v).empty())) continue;
      is_bad[v] = 1;
      any = true;
    }
    for (std::size_t f = 0; any && f < face_of_.size(); ++f)
      for (std::size_t c = 0; c < 3; ++c)
        if (is_bad[source_.mesh.triangles[3 * f + c]] != 0) face_of_[f] = kNotJoined;
    return any;
  }

  PartMatch result() const {
    PartMatch match;
    match.stays.assign(base_.part.mesh.triangle_count(), 0);
    match.base_of.assign(base_of_.size(), kNotJoined);
    std::vector<std::uint32_t> source_of(base_.part.mesh.vertex_count(), kNotJoined);
    for (std::uint32_t f = 0; f < face_of_.size(); ++f) {
      if (face_of_[f] == kNotJoined) {
        match.new_faces.push_back(f);
        continue;
      }
      match.stays[face_of_[f]] = 1;
      for (std::size_t c = 0; c < 3; ++c) {
        const std::uint32_t v = source_.mesh.triangles[3 * std::size_t{f} + c];
        match.base_of[v] = base_of_[v];
        source_of[base_of_[v]] = v;
      }
    }
    match.is_base_whole = std::ranges::find(match.stays, 0) == match.stays.end();
    for (std::uint32_t v = 0; v < source_of.size(); ++v) {
      if (source_of[v] == kNotJoined) continue;
      match.source_of.push_back(source_of[v]);
    }
    return match;
  }

  const MapPart& source_;
  const BaseVersion& base_;
  const MatchBounds& bounds_;
  std::vector<std::uint32_t> base_of_;  ///< of the source's vertices
  std::vector<std::uint32_t> face_of_;  ///< of the source's faces
};

}  // namespace

PartMatch match_part(const MapPart& source, const BaseVersion& base, const MatchBounds& bounds) {
  const bool are_fit = source.mesh.face_groups.empty() && base.part.mesh.face_groups.empty() &&
                       std::ranges::equal(source.mesh.attributes, base.part.mesh.attributes, are_colors);
  if (are_fit) return Matcher(source, base, bounds).run();
  PartMatch match;
  match.stays.assign(base.part.mesh.triangle_count(), 0);
  match.base_of.assign(source.mesh.vertex_count(), kNotJoined);
  for (std::uint32_t f = 0; f < source.mesh.triangle_count(); ++f) match.new_faces.push_back(f);
  return match;
}

}  // namespace deltamesh
