// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "patch/match.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

#include "lattice/positions.h"
#include "patch/coder.h"
#include "support/color_value.h"
#include "support/open_edges.h"

namespace deltamesh {
namespace {

std::uint64_t hash_of(const std::array<std::uint32_t, 3>& numbers) noexcept {
  std::uint64_t hash = 0;
  for (const std::uint32_t n : numbers) hash = (hash ^ n) * 0x9e3779b97f4a7c15U;
  return hash ^ hash >> 32;
}

/// Lists of rows by hash.
class RowLists {
 public:
  explicit RowLists(std::size_t rows)
      : first_(std::bit_ceil(rows + 1), kNotJoined), next_(rows, kNotJoined) {}

  void add(std::uint64_t hash, std::uint32_t row) {
    std::uint32_t& first = first_[hash & (first_.size() - 1)];
    next_[row] = std::exchange(first, row);
  }
  /// All rows of the hash, and perhaps others, descending where they were added ascending.
  std::uint32_t first(std::uint64_t hash) const noexcept { return first_[hash & (first_.size() - 1)]; }
  std::uint32_t next(std::uint32_t row) const noexcept { return next_[row]; }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> next_;
};

double squared_distance(const float* a, const float* b) noexcept {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += (double{a[k]} - b[k]) * (double{a[k]} - b[k]);
  return sum;
}

/// Finds the vertex nearest to a place within a radius.
class NearRows {
 public:
  NearRows(std::span<const float> positions, double radius)
      : positions_(positions), edge_(2 * radius), cells_(positions.size() / 3) {
    for (std::uint32_t v = 0; v < positions.size() / 3; ++v) {
      std::array<std::uint32_t, 3> cell{};
      for (std::size_t k = 0; k < 3; ++k) cell[k] = step_of(double{positions_[3 * std::size_t{v} + k]});
      cells_.add(hash_of(cell), v);
    }
  }

  std::uint32_t nearest(const float* place) const noexcept {
    std::uint32_t best = kNotJoined;
    double least = edge_ * edge_ / 4;
    std::array<std::uint32_t, 3> low{};
    for (std::size_t k = 0; k < 3; ++k) low[k] = step_of(double{place[k]} - edge_ / 2);
    for (unsigned corner = 0; corner < 8; ++corner) {
      std::array<std::uint32_t, 3> cell = low;
      for (std::size_t k = 0; k < 3; ++k) cell[k] += corner >> k & 1U;
      for (std::uint32_t v = cells_.first(hash_of(cell)); v != kNotJoined; v = cells_.next(v)) {
        const double squared = squared_distance(place, positions_.data() + 3 * std::size_t{v});
        if (squared < least || (squared == least && v < best)) {
          least = squared;
          best = v;
        }
      }
    }
    return best;
  }

 private:
  std::uint32_t step_of(double x) const noexcept {
    return static_cast<std::uint32_t>(
        static_cast<std::int32_t>(std::clamp(std::floor(x / edge_), -2e9, 2e9)));
  }

  std::span<const float> positions_;
  double edge_;
  RowLists cells_;
};

/// Whether several vertices have the position.
std::vector<std::uint8_t> shared_positions(const Mesh& mesh) {
  std::vector<std::uint8_t> is_shared(mesh.vertex_count(), 0);
  RowLists lists(mesh.vertex_count());
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    const PositionBits bits = bits_of(mesh, v);
    for (std::uint32_t u = lists.first(hash_of(bits)); u != kNotJoined; u = lists.next(u))
      if (bits_of(mesh, u) == bits) is_shared[u] = is_shared[v] = 1;
    lists.add(hash_of(bits), v);
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
      if (near == kNotJoined || !is_good_enough(v, near) || source_border[v] != base_border[near]) continue;
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

  bool is_good_enough(std::uint32_t v, std::uint32_t base) const noexcept {
    if (squared_distance(source_.mesh.positions.data() + 3 * std::size_t{v},
                         base_.part.mesh.positions.data() + 3 * std::size_t{base}) >
        bounds_.max_error * bounds_.max_error)
      return false;
    for (std::size_t a = 0; a < source_.mesh.attributes.size(); ++a)
      if (color_difference(a, v, base) > bounds_.color_error) return false;
    return true;
  }

  double color_difference(std::size_t attribute, std::uint32_t v, std::uint32_t base) const noexcept {
    const Attribute& ours = source_.mesh.attributes[attribute];
    const Attribute& theirs = base_.part.mesh.attributes[attribute];
    double most = 0;
    for (std::size_t c = 0; c < ours.components; ++c)
      most = std::max(most, std::abs(color_value(ours, v, c) - color_value(theirs, base, c)));
    return most;
  }

  void match_faces() {
    const auto face_at = [](const std::vector<std::uint32_t>& triangles, std::size_t f) {
      return std::array{triangles[3 * f], triangles[3 * f + 1], triangles[3 * f + 2]};
    };
    const auto& theirs = base_.part.mesh.triangles;
    RowLists faces(theirs.size() / 3);
    for (std::uint32_t f = 0; f < theirs.size() / 3; ++f) faces.add(hash_of(rotated(face_at(theirs, f))), f);
    std::vector<std::uint8_t> is_taken(theirs.size() / 3, 0);
    const auto& ours = source_.mesh.triangles;
    face_of_.assign(ours.size() / 3, kNotJoined);
    for (std::size_t f = 0; f < face_of_.size(); ++f) {
      auto face = face_at(ours, f);
      for (std::uint32_t& v : face) v = base_of_[v];
      if (std::ranges::find(face, kNotJoined) != face.end()) continue;
      face = rotated(face);
      std::uint32_t found = faces.first(hash_of(face));
      while (found != kNotJoined && (is_taken[found] != 0 || rotated(face_at(theirs, found)) != face))
        found = faces.next(found);
      if (found == kNotJoined) continue;
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
