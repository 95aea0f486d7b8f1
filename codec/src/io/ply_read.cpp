// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "base/try.h"
#include "io/components.h"
#include "io/faces.h"
#include "io/formats.h"
#include "io/origin.h"
#include "io/ply_body.h"
#include "io/ply_layout.h"

namespace deltamesh {
namespace {

constexpr const char* kTooMany = "PLY: the file is too short for the number of elements it states";

Result<void> read_vertices(PlyBody& body, const PlyElement& vertex, Imported& imported) {
  if (vertex.count > std::numeric_limits<std::uint32_t>::max()) return body.at("PLY: too many vertices");
  PlyVertexLayout layout = layout_ply_vertex(vertex);
  if (!layout.has_position) return body.at("PLY: the vertices have no x, y, z");
  Mesh& mesh = imported.mesh;
  imported.notes.dropped_attributes = layout.unnamed;
  for (Attribute& attribute : layout.attributes)
    attribute.values.resize(vertex.count * attribute.components * component_size(attribute.type));
  std::vector<double> coordinates(vertex.count * 3);

  for (std::size_t v = 0; v < vertex.count; ++v) {
    for (std::size_t p = 0; p < vertex.properties.size(); ++p) {
      const PlyProperty& property = vertex.properties[p];
      double value = 0;
      double length = 1;
      if (property.is_list && !body.next(property.count_type, length)) return body.error();
      for (double i = 0; i < length; ++i)
        if (!body.next(property.type, value)) return body.error();
      const PlyTarget& target = layout.targets[p];
      if (target.kind == PlyTarget::Kind::kPosition) {
        coordinates[3 * v + target.component] = value;
      } else if (target.kind == PlyTarget::Kind::kAttribute) {
        Attribute& attribute = layout.attributes[target.attribute];
        const std::size_t at = (v * attribute.components + target.component) * component_size(attribute.type);
        store_component(attribute.type, value, attribute.values.data() + at);
      }
    }
  }
  PlacedPositions placed = place_origin(coordinates);
  mesh.origin = placed.origin;
  mesh.positions = std::move(placed.positions);
  mesh.attributes = std::move(layout.attributes);
  return {};
}

/// The property that lists the corners of a face.
std::optional<std::size_t> corner_list(const PlyElement& face) noexcept {
  for (std::size_t i = 0; i < face.properties.size(); ++i) {
    const PlyProperty& property = face.properties[i];
    if (property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index")) return i;
  }
  return std::nullopt;
}

Result<void> read_faces(PlyBody& body, const PlyElement& face, std::uint64_t vertices, FaceCollector& faces) {
  const auto corner_property = corner_list(face);
  if (!corner_property) return body.at("PLY: the faces have no list vertex_indices");
  std::vector<std::uint32_t> corners;
  for (std::uint64_t f = 0; f < face.count; ++f) {
    corners.clear();
    for (std::size_t p = 0; p < face.properties.size(); ++p) {
      const PlyProperty& property = face.properties[p];
      double length = 1;
      if (property.is_list && !body.next(property.count_type, length)) return body.error();
      if (length < 0) return body.at("PLY: a list of negative length");
      // Every entry takes bytes, so the loop ends with them.
      for (double i = 0; i < length; ++i) {
        double value = 0;
        if (!body.next(property.type, value)) return body.error();
        if (p != *corner_property) continue;
        if (!(value >= 0 && value < static_cast<double>(vertices)))
          return body.at("PLY: a face names a vertex that does not exist");
        corners.push_back(static_cast<std::uint32_t>(value));
      }
    }
    faces.add(corners);
  }
  return {};
}

const PlyElement* find_element(const PlyHeader& header, std::string_view name) noexcept {
  const auto found = std::find_if(header.elements.begin(), header.elements.end(),
                                  [name](const PlyElement& element) { return element.name == name; });
  return found == header.elements.end() ? nullptr : &*found;
}

}  // namespace

Result<Imported> read_ply(std::span<const std::byte> bytes) {
  DELTAMESH_TRY(const PlyHeader header, read_ply_header(bytes));
  PlyBody body(bytes, header);
  const PlyElement* const vertex = find_element(header, "vertex");
  const PlyElement* const face = find_element(header, "face");
  if (vertex == nullptr) return body.at("PLY: the file has no vertices");
  const PlyElement* const strips = find_element(header, "tristrips");
  if (strips != nullptr && strips->count > 0 && (face == nullptr || face->count == 0))
    return body.at("PLY: triangle strips are not supported; save the mesh with faces");

  Imported imported;
  FaceCollector faces;
  for (const PlyElement& element : header.elements) {
    if (!body.may_hold(element)) return body.at(kTooMany);
    if (&element == vertex) {
      DELTAMESH_CHECK(read_vertices(body, element, imported));
    } else if (&element == face) {
      DELTAMESH_CHECK(read_faces(body, element, vertex->count, faces));
    } else if (!element.properties.empty()) {
      for (std::uint64_t row = 0; row < element.count; ++row)
        if (!body.skip_row(element)) return body.error();
      if (element.name == "edge") imported.notes.other_primitives += element.count;
    }
  }
  faces.move_into(imported);
  return imported;
}

}  // namespace deltamesh
