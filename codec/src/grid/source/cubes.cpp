// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "grid/source/cubes.h"

#include <algorithm>

namespace deltamesh::grid {
namespace {

std::array<std::uint32_t, 3> corners_of(std::span<const std::uint32_t> triangles, std::size_t face) noexcept {
  return {triangles[3 * face], triangles[3 * face + 1], triangles[3 * face + 2]};
}

}  // namespace

SourceCubes::SourceCubes(std::span<const std::uint32_t> triangles, std::span<const Cell> cells,
                         std::uint32_t levels, const std::array<std::uint32_t, 3>& bricks)
    : triangles_(triangles), cells_(cells), voxel_(2 * static_cast<std::int32_t>(levels)), bricks_(bricks) {
  find_cubes(EdgeVertices(cells, voxel_));
  for (std::uint32_t cube = 0; cube < cubes_.size(); ++cube) vote(cube);
  signs_.resize(cubes_.size());
  for (std::uint32_t cube = 0; cube < cubes_.size(); ++cube) settle_signs(cube);
}

SourceCubes::Address SourceCubes::address_of(const Node& node) {
  const auto at = [&](std::size_t axis) { return static_cast<std::uint32_t>(node[axis]) / kSide; };
  const std::uint32_t brick = (at(2) * bricks_[1] + at(1)) * bricks_[0] + at(0);
  if (brick != last_brick_) {
    const auto [found, is_new] = part_numbers_.try_emplace(brick, static_cast<std::uint32_t>(parts_.size()));
    if (is_new) parts_.push_back(std::make_unique<Part>());
    if (is_new && !cubes_.empty()) parts_.back()->cubes.fill(Part::kNoCube);
    last_brick_ = brick;
    last_part_ = found->second;
  }
  return {last_part_, place_of({node[0] % kSide, node[1] % kSide, node[2] % kSide})};
}

/// A cube takes no more faces than a pattern can have.
void SourceCubes::count_face(const Address& home) noexcept {
  std::uint16_t& faces = parts_[home.part]->cubes[home.place];
  faces = static_cast<std::uint16_t>(faces + (faces < Pattern::kMostTriangles ? 1 : 0));
}

void SourceCubes::find_cubes(const EdgeVertices& vertices) {
  const std::size_t count = triangles_.size() / 3;
  std::vector<Address> homes(count);
  std::vector<std::uint32_t> open;
  for (std::size_t f = 0; f < count; ++f) {
    const auto cubes = vertices.cubes_of(corners_of(triangles_, f));
    if (cubes.count == 2) open.push_back(static_cast<std::uint32_t>(f));
    if (cubes.count != 1) continue;
    homes[f] = address_of(cubes.lowest[0]);
    count_face(homes[f]);
  }
  // A face between two cubes goes to the one that has others.
  for (const std::uint32_t f : open) {
    const auto cubes = vertices.cubes_of(corners_of(triangles_, f));
    const auto& low = cubes.lowest[0];
    homes[f] = address_of(cubes.lowest[1]);
    if (std::min({low[0], low[1], low[2]}) >= 0 && parts_[homes[f].part]->cubes[homes[f].place] == 0)
      homes[f] = address_of(low);
    count_face(homes[f]);
  }
  place_faces(vertices, homes);
}

void SourceCubes::place_faces(const EdgeVertices& vertices, std::span<const Address> homes) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> order(part_numbers_.begin(), part_numbers_.end());
  std::sort(order.begin(), order.end());
  cubes_.reserve(homes.size() / 2);  // about what most grids have
  first_face_.reserve(homes.size() / 2);
  first_face_.push_back(0);
  for (const auto& [brick, part] : order) {
    const Bricks::Place at = {static_cast<std::int32_t>(brick % bricks_[0]),
                              static_cast<std::int32_t>(brick / bricks_[0] % bricks_[1]),
                              static_cast<std::int32_t>(brick / bricks_[0] / bricks_[1])};
    const auto first = static_cast<std::uint32_t>(cubes_.size());
    parts_[part]->first_cube = first;
    for (std::uint32_t place = 0; place < kPlaces; ++place) {
      std::uint16_t& cube = parts_[part]->cubes[place];
      if (cube != 0) first_face_.push_back(first_face_.back() + cube);
      if (cube != 0) cubes_.push_back({at, place});
      cube = cube != 0 ? static_cast<std::uint16_t>(cubes_.size() - 1 - first) : Part::kNoCube;
    }
  }
  faces_.resize(first_face_.back());
  std::vector<std::uint32_t> next(first_face_.begin(), first_face_.end() - 1);
  for (std::uint32_t f = 0; f < homes.size(); ++f) {
    if (homes[f].part == kNone) {
      left_faces_.push_back(f);
      continue;
    }
    const std::uint32_t cube = parts_[homes[f].part]->cube(homes[f].place);
    if (next[cube] - first_face_[cube] == Pattern::kMostTriangles) {
      left_faces_.push_back(f);
      continue;
    }
    Node lowest{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      lowest[axis] = cubes_[cube].brick[axis] * kSide + spot_of(homes[f].place)[axis];
    const auto turned = with_least_first(vertices.seen_from(lowest, corners_of(triangles_, f)));
    faces_[next[cube]++] = {turned.corners, turned.turn, f};
  }
  patterns_.resize(cubes_.size());
  for (std::uint32_t cube = 0; cube < cubes_.size(); ++cube) {
    Face* const first = faces_.data() + first_face_[cube];
    std::sort(first, faces_.data() + next[cube]);
    for (const Face* face = first; face != faces_.data() + next[cube]; ++face)
      patterns_[cube].add(face->corners);
  }
}

std::array<std::int8_t*, kCorners> SourceCubes::signs_around(std::uint32_t cube) {
  Node lowest{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    lowest[axis] = cubes_[cube].brick[axis] * kSide + spot_of(cubes_[cube].place)[axis];
  std::array<std::int8_t*, kCorners> signs{};
  const bool is_inner = beyond(cubes_[cube].place) == 0;
  const Address first = address_of(lowest);
  for (unsigned corner = 0; corner < kCorners; ++corner) {
    const Node node = {lowest[0] + static_cast<int>(corner & 1),
                       lowest[1] + static_cast<int>(corner >> 1 & 1),
                       lowest[2] + static_cast<int>(corner >> 2)};
    const Address address =
        is_inner ? Address{first.part, first.place + kCornerSteps[corner]} : address_of(node);
    signs[corner] = &parts_[address.part]->signs[address.place];
  }
  return signs;
}

/// Outside is where the faces at an edge look.
void SourceCubes::vote(std::uint32_t cube) {
  std::array<int, kEdges> votes{};
  for (const Triangle& triangle : patterns_[cube].triangles()) {
    const Node normal = normal_of(triangle);
    for (const unsigned edge : triangle) {
      if (edge == kInside) continue;
      const std::int32_t way = normal[edge / 4];
      votes[edge] += (way > 0 ? 1 : 0) - (way < 0 ? 1 : 0);
    }
  }
  const auto signs = signs_around(cube);
  for (unsigned edge = 0; edge < kEdges; ++edge) {
    if (votes[edge] == 0) continue;
    const int way = votes[edge] > 0 ? 1 : -1;
    std::int8_t& first = *signs[first_corner(edge)];
    first = static_cast<std::int8_t>(first - way);
    std::int8_t& last = *signs[last_corner(edge)];
    last = static_cast<std::int8_t>(last + way);
  }
}

/// Corners without a vote are on the side of those along edges that are not cut.
void SourceCubes::settle_signs(std::uint32_t cube) {
  std::array<std::int8_t, kCorners> sign{};
  const auto signs = signs_around(cube);
  for (unsigned corner = 0; corner < kCorners; ++corner) sign[corner] = *signs[corner];
  const auto is_open = [&] { return std::find(sign.begin(), sign.end(), 0) != sign.end(); };
  for (unsigned round = 0; round < kCorners && is_open(); ++round) {
    for (unsigned edge = 0; edge < kEdges; ++edge) {
      if ((patterns_[cube].used() >> edge & 1) != 0) continue;
      std::int8_t& first = sign[first_corner(edge)];
      std::int8_t& last = sign[last_corner(edge)];
      if (first == 0) first = last;
      if (last == 0) last = first;
    }
  }
  for (unsigned corner = 0; corner < kCorners; ++corner) {
    std::int8_t& kept = *signs[corner];
    if (kept == 0) kept = sign[corner] != 0 ? sign[corner] : std::int8_t{1};
    signs_[cube] |= (kept > 0 ? 1U : 0U) << corner;
  }
}

std::uint32_t SourceCubes::find(const Bricks::Place& brick, std::uint32_t place) const noexcept {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (static_cast<std::uint32_t>(brick[axis]) >= bricks_[axis]) return kNone;
  const auto at = [&](std::size_t axis) { return static_cast<std::uint32_t>(brick[axis]); };
  const auto found = part_numbers_.find((at(2) * bricks_[1] + at(1)) * bricks_[0] + at(0));
  return found == part_numbers_.end() ? kNone : parts_[found->second]->cube(place);
}

std::uint32_t SourceCubes::inner_offset(std::uint32_t cube, std::size_t axis) const noexcept {
  for (const Face& face : faces(cube)) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (face.corners[c] != kInside) continue;
      const std::uint32_t vertex = triangles_[3 * std::size_t{face.face} + (face.turn + c) % 3];
      return static_cast<std::uint32_t>(cells_[vertex][axis] % voxel_);
    }
  }
  return 0;
}

}  // namespace deltamesh::grid
