// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "split/stored_block.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>

#include "base/try.h"
#include "base/with_found.h"
#include "connectivity/check_mesh.h"
#include "support/content_hash.h"
#include "support/errors.h"
#include "support/row_gather.h"

namespace deltamesh {
namespace {

/// What it is for people: its name only where the kind says nothing.
std::string_view text_of(AttributeKind kind, std::string_view name) noexcept {
  constexpr std::array<const char*, 7> kNames{
      "normals", "colours", "texture coordinates", "generic", "tangents", "joints", "weights"};
  return kind != AttributeKind::kGeneric || name.empty() ? kNames.at(static_cast<std::size_t>(kind)) : name;
}

/// The first of the one that the other has less often; both by kind and name.
template <class Ones, class Others>
Result<void> check_all_in(const Ones& ones, const Others& others, const char* message) {
  for (const auto& one : ones) {
    const auto is_same = [&](const auto& a) { return a.kind == one.kind && a.name == one.name; };
    if (std::ranges::count_if(ones, is_same) <= std::ranges::count_if(others, is_same)) continue;
    return with_found(invalid_mesh(message), text_of(one.kind, one.name));
  }
  return {};
}

Result<void> check_attributes(const MeshView& mesh, const MapDescription& description) {
  DELTAMESH_CHECK(
      check_all_in(mesh.attributes, description.attributes, "the map lacks an attribute of the mesh"));
  DELTAMESH_CHECK(
      check_all_in(description.attributes, mesh.attributes, "the mesh lacks an attribute of the map"));
  for (std::size_t i = 0; i < mesh.attributes.size(); ++i) {
    const AttributeView& a = mesh.attributes[i];
    const MapAttribute& b = description.attributes[i];
    if (a.kind != b.kind || a.type != b.type || a.components != b.components ||
        a.normalized != b.normalized || a.name != b.name || a.linear != b.linear)
      return invalid_mesh("an attribute of the mesh is not that of the map", WhereKind::kAttribute, i);
  }
  return {};
}

/// a / b rounded down; b above 0.
std::int64_t floor_div(std::int64_t a, std::int64_t b) noexcept {
  return a / b - (a % b != 0 && a < 0 ? 1 : 0);
}

/// The middle of the cube that `position` is in, model units.
std::array<float, 3> middle_of_cube(const VoxelGrid& grid, const std::array<double, 3>& position) noexcept {
  std::array<float, 3> middle{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double cube = std::floor((position[k] - grid.origin[k]) / grid.edge[k]);
    middle[k] = static_cast<float>(grid.origin[k] + (cube + 0.5) * grid.edge[k]);
  }
  return middle;
}

/// The lattice points whose mean decides about a face [MAP-4]: those of its corners, or three times that of
/// the middle of its cube.
std::array<LatticePoint, 3> points_of_face(const Mesh& mesh, std::size_t face,
                                           const MapDescription& description) noexcept {
  const MapLattice& lattice = description.lattice;
  std::array<LatticePoint, 3> points{};
  std::array<double, 3> centroid{};
  for (std::size_t c = 0; c < 3; ++c) {
    const float* p = mesh.positions.data() + 3 * std::size_t{mesh.triangles[3 * face + c]};
    points[c] = lattice.nearest({p[0], p[1], p[2]});
    for (std::size_t k = 0; k < 3; ++k) centroid[k] += double{p[k]} / 3;
  }
  if (!description.grid) return points;
  const auto middle = middle_of_cube(*description.grid, centroid);
  if (lattice.is_within(middle)) points.fill(lattice.nearest(middle));
  return points;
}

Cell0 cell_of_face(const Mesh& mesh, std::size_t face, const MapDescription& description) noexcept {
  const auto [a, b, c] = points_of_face(mesh, face, description);
  Cell0 cell{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int64_t sum = std::int64_t{a[k]} + b[k] + c[k];
    cell[k] = static_cast<std::int32_t>(floor_div(sum - 3 * std::int64_t{description.cell_origin[k]},
                                                  3 * std::int64_t{description.cell_steps}));
  }
  return cell;
}

std::uint64_t hash_of_mesh(const Mesh& mesh) {
  ContentHash hash;
  hash.add(std::span<const float>(mesh.positions));
  hash.add(std::span<const std::uint32_t>(mesh.triangles));
  hash.add(std::span<const std::uint32_t>(mesh.face_groups));
  for (const Attribute& attribute : mesh.attributes) hash.add(std::span<const std::byte>(attribute.values));
  return hash.digest();
}

}  // namespace

Result<Mesh> to_map(const MeshView& mesh, const MapDescription& description) {
  DELTAMESH_CHECK(check_mesh(mesh));
  DELTAMESH_CHECK(check_attributes(mesh, description));
  RowGather gather(mesh);
  for (std::size_t f = 0; f < mesh.triangle_count(); ++f) gather.add_face(f);
  const std::vector<std::uint32_t> rows = gather.rows();
  Mesh moved = gather.take();
  moved.origin = description.lattice.origin;
  for (std::size_t v = 0; v < moved.vertex_count(); ++v) {
    float* p = moved.positions.data() + 3 * v;
    for (std::size_t k = 0; k < 3; ++k) {
      const double shift = mesh.origin[k] - description.lattice.origin[k];
      p[k] = static_cast<float>(double{p[k]} + shift) + 0.0F;  // one zero
    }
    if (!description.lattice.is_within({p[0], p[1], p[2]}))
      return Error{
          .code = ErrorCode::kUnmetRequest,
          .message =
              "a position is 2^24 steps of the map's lattice or more from its origin; ask for a larger error",
          .rule = "MAP-2",
          .where_kind = WhereKind::kVertex,
          .where = rows[v]};
  }
  return moved;
}

StoredBlock store_block(Mesh mesh) {
  const std::uint64_t hash = hash_of_mesh(mesh);
  return {std::move(mesh), hash};
}

StoredBlocks blocks_of(const Mesh& mesh, const MapDescription& description) {
  std::map<Cell0, std::vector<std::size_t>> faces;
  for (std::size_t f = 0; f < mesh.triangle_count(); ++f)
    faces[cell_of_face(mesh, f, description)].push_back(f);
  StoredBlocks blocks;
  RowGather gather{MeshView(mesh)};
  for (const auto& [cell, list] : faces) {
    for (const std::size_t f : list) gather.add_face(f);
    blocks.emplace(cell, store_block(gather.take()));
  }
  return blocks;
}

}  // namespace deltamesh
