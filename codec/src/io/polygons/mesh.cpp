// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/polygons/mesh.h"

#include <array>
#include <cstring>
#include <limits>
#include <string_view>

#include "base/try.h"
#include "io/colors.h"
#include "io/components.h"
#include "io/first_equal.h"
#include "io/io_error.h"
#include "io/origin.h"
#include "io/polygons/triangulate.h"

namespace deltamesh {
namespace {

constexpr std::size_t kMostCornerValues = 3;

std::size_t value_size(const Attribute& attribute) noexcept {
  return attribute.components * component_size(attribute.type);
}

/// The mesh's vertices, each given by a corner that makes it or by a position that no corner uses.
struct Split {
  std::vector<std::uint32_t> vertices;   ///< of every corner
  std::vector<std::uint32_t> corners;    ///< of every vertex; CornerValues::kNone where none is there
  std::vector<std::uint32_t> positions;  ///< of every vertex
};

Split split_corners(const PolygonMesh& mesh) {
  const std::span<const std::uint32_t> corners = mesh.faces.corners();
  const auto key = [&](std::uint32_t c) {
    std::array<std::uint32_t, 1 + kMostCornerValues> indices{corners[c]};
    for (std::size_t k = 0; k < mesh.corner_values.size(); ++k)
      indices[k + 1] = mesh.corner_values[k].index[c];
    return indices;
  };
  const std::vector<std::uint32_t> first = first_equal(corners.size(), key);
  Split split;
  const std::size_t positions = mesh.coordinates.size() / 3;
  split.corners.resize(positions, CornerValues::kNone);
  for (std::size_t v = 0; v < positions; ++v) split.positions.push_back(static_cast<std::uint32_t>(v));
  split.vertices.resize(corners.size());
  for (std::uint32_t c = 0; c < corners.size(); ++c) {
    const std::uint32_t own = corners[c];
    if (first[c] != c) {
      split.vertices[c] = split.vertices[first[c]];
    } else if (split.corners[own] == CornerValues::kNone) {
      split.corners[own] = c;
      split.vertices[c] = own;
    } else {
      split.vertices[c] = static_cast<std::uint32_t>(split.positions.size());
      split.corners.push_back(c);
      split.positions.push_back(own);
    }
  }
  return split;
}

/// The records that `index(v)` names of `count` vertices.
template <class Index>
Attribute gather(Attribute records, std::size_t count, Index index) {
  const std::size_t size = value_size(records);
  std::vector<std::byte> values(count * size);
  for (std::size_t v = 0; v < count; ++v)
    if (const std::uint32_t record = index(v); record != CornerValues::kNone)
      std::memcpy(&values[v * size], &records.values[record * size], size);
  records.values = std::move(values);
  return records;
}

/// Positions and attributes of the split vertices.
void apply(const Split& split, PolygonMesh& mesh) {
  const std::size_t count = split.positions.size();
  const auto position = [&](std::size_t v) { return split.positions[v]; };
  for (Attribute& attribute : mesh.attributes) attribute = gather(std::move(attribute), count, position);
  for (std::size_t v = mesh.coordinates.size() / 3; v < count; ++v)
    for (std::size_t k = 0; k < 3; ++k)
      mesh.coordinates.push_back(mesh.coordinates[3 * split.positions[v] + k]);
  for (CornerValues& values : mesh.corner_values) {
    const auto record = [&](std::size_t v) {
      return split.corners[v] == CornerValues::kNone ? CornerValues::kNone : values.index[split.corners[v]];
    };
    mesh.attributes.push_back(gather(std::move(values.records), count, record));
  }
}

/// Triangles of the faces, their corners named by `vertices`.
Result<void> add_triangles(const PolygonMesh& from, std::span<const std::uint32_t> vertices,
                           Imported& imported) {
  std::vector<Vec3> points;
  std::vector<std::uint32_t> local;
  Mesh& mesh = imported.mesh;
  mesh.triangles.reserve(vertices.size());
  for (std::size_t f = 0; f < from.faces.count(); ++f) {
    const auto corners = vertices.subspan(from.faces.begin(f), from.faces.end(f) - from.faces.begin(f));
    local.clear();
    if (corners.size() == 3) {
      local = {0, 1, 2};
    } else {
      points.clear();
      for (const std::uint32_t v : corners) points.push_back(widen(&from.coordinates[std::size_t{3} * v]));
      if (!triangulate(points, local))
        return invalid_file("a polygon of more than 4,096 corners that no fan fills", WhereKind::kElement, f);
      ++imported.report.polygons;
    }
    for (const std::uint32_t corner : local) mesh.triangles.push_back(corners[corner]);
    if (!from.face_groups.empty())
      mesh.face_groups.insert(mesh.face_groups.end(), local.size() / 3, from.face_groups[f]);
  }
  return {};
}

}  // namespace

CornerValues index_values(Attribute values, std::span<const std::uint32_t> owners) {
  const std::size_t size = value_size(values);
  const std::string_view bytes(reinterpret_cast<const char*>(values.values.data()), values.values.size());
  const std::vector<std::uint32_t> first =
      first_equal(bytes.size() / size, [&](std::uint32_t i) { return bytes.substr(i * size, size); });
  CornerValues result{.records = std::move(values), .index = {}};
  result.index.reserve(owners.size());
  for (const std::uint32_t owner : owners)
    result.index.push_back(owner == CornerValues::kNone ? owner : first[owner]);
  return result;
}

Result<Imported> to_triangles(PolygonMesh mesh, ReadReport report) {
  const std::span<const std::uint32_t> corners = mesh.faces.corners();
  if (mesh.coordinates.size() / 3 + corners.size() > std::numeric_limits<std::uint32_t>::max())
    return invalid_file("more corners than a 32-bit index can name");
  for (Attribute& attribute : mesh.attributes) settle_range(attribute, report);
  for (CornerValues& values : mesh.corner_values) settle_range(values.records, report);
  Split split;
  if (!mesh.corner_values.empty()) {
    split = split_corners(mesh);
    apply(split, mesh);
  }
  Imported imported{.report = std::move(report)};
  imported.mesh.group_names = std::move(mesh.group_names);
  imported.report.leave_out(LeftOutKind::kFaces, "of fewer than three corners", mesh.faces.dropped());
  std::vector<std::uint32_t> vertices =
      mesh.corner_values.empty() ? mesh.faces.take_corners() : std::move(split.vertices);
  place_origin(mesh.coordinates, vertices, imported);
  if (mesh.faces.are_triangles()) {
    imported.mesh.triangles = std::move(vertices);
    imported.mesh.face_groups = std::move(mesh.face_groups);
  } else {
    DELTAMESH_CHECK(add_triangles(mesh, vertices, imported));
  }
  imported.mesh.attributes = std::move(mesh.attributes);
  return imported;
}

}  // namespace deltamesh
