// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <utility>

#include "base/try.h"
#include "io/components.h"
#include "io/formats.h"
#include "io/ply/body.h"
#include "io/ply/faces.h"
#include "io/ply/header.h"
#include "io/polygons/mesh.h"

namespace deltamesh {
namespace {

Result<void> read_vertices(PlyBody& body, const PlyElement& vertex, PolygonMesh& mesh, ReadReport& report) {
  if (vertex.count > std::numeric_limits<std::uint32_t>::max()) return body.at("PLY: too many vertices");
  PlyLayout layout = layout_ply_element(vertex);
  if (!layout.has_position) return body.at("PLY: the vertices have no x, y, z");
  for (std::size_t p = 0; p < layout.targets.size(); ++p)
    if (layout.targets[p].kind == PlyTarget::Kind::kSkip)
      report.leave_out(LeftOutKind::kVertexValues, vertex.properties[p].name, vertex.count);
  for (Attribute& attribute : layout.attributes)
    attribute.values.resize(vertex.count * attribute.components * component_size(attribute.type));
  mesh.coordinates.resize(vertex.count * 3);

  std::vector<std::uint64_t> rounded(vertex.properties.size());
  std::size_t v = 0;
  const auto take = [&](std::size_t property, double value) -> const char* {
    const PlyTarget& target = layout.targets[property];
    if (target.kind == PlyTarget::Kind::kPosition) {
      mesh.coordinates[3 * v + target.component] = value;
    } else if (target.kind == PlyTarget::Kind::kAttribute) {
      Attribute& attribute = layout.attributes[target.attribute];
      const std::size_t at = (v * attribute.components + target.component) * component_size(attribute.type);
      store_component(attribute.type, value, attribute.values.data() + at);
      if (attribute.type == ComponentType::kF32 && vertex.properties[property].type == ComponentType::kF64)
        rounded[property] += static_cast<double>(to_float(value)) == value || std::isnan(value) ? 0 : 1;
    }
    return nullptr;
  };
  for (; v < vertex.count; ++v) DELTAMESH_CHECK(body.read_row(vertex, take));
  for (std::size_t p = 0; p < rounded.size(); ++p)
    report.leave_out(LeftOutKind::kPrecision, vertex.properties[p].name, rounded[p]);
  mesh.attributes = std::move(layout.attributes);
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

  PolygonMesh mesh;
  PlyFaces faces;
  ReadReport report;
  report.leave_out(LeftOutKind::kElements, "TextureFile", header.textures);
  for (const PlyElement& element : header.elements) {
    if (!body.may_hold(element))
      return body.at("PLY: the file is too short for the number of elements it states");
    if (&element == vertex) {
      DELTAMESH_CHECK(read_vertices(body, element, mesh, report));
    } else if (&element == face) {
      DELTAMESH_CHECK(faces.read(body, element, vertex->count));
    } else if (!element.properties.empty()) {
      for (std::uint64_t row = 0; row < element.count; ++row)
        DELTAMESH_CHECK(body.read_row(element, [](std::size_t, double) -> const char* { return nullptr; }));
      const bool edges = element.name == "edge";
      report.leave_out(edges ? LeftOutKind::kPrimitives : LeftOutKind::kElements,
                       edges ? "edges" : element.name, element.count);
    }
  }
  DELTAMESH_TRY(const std::uint64_t behind, body.end());
  report.leave_out(LeftOutKind::kElements, "bytes behind the last element", behind);
  faces.move_into(mesh, report);
  return to_triangles(std::move(mesh), std::move(report));
}

}  // namespace deltamesh
