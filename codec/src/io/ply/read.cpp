// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "base/try.h"
#include "io/components.h"
#include "io/formats.h"
#include "io/ply/body.h"
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

/// The faces of a PLY file: their corners, colours, and the texture coordinates of corners.
class PlyFaces {
 public:
  /// The face element, of a mesh of `vertices` vertices. Errors: kInvalidFile.
  Result<void> read(PlyBody& body, const PlyElement& face, std::uint64_t vertices) {
    choose_roles(face);
    if (std::find(roles_.begin(), roles_.end(), Role::kCorners) == roles_.end())
      return body.at("PLY: the faces have no list vertex_indices");
    constexpr const char* kNoSuchVertex = "PLY: a face names a vertex that does not exist";
    const auto take = [&](std::size_t property, double value) -> const char* {
      switch (roles_[property]) {
        case Role::kCorners:
          if (!(value >= 0 && value < static_cast<double>(vertices))) return kNoSuchVertex;
          corners_.push_back(static_cast<std::uint32_t>(value));
          if (static_cast<double>(corners_.back()) != value) return kNoSuchVertex;
          break;
        case Role::kUvs:
          face_uvs_.push_back(value);
          break;
        case Role::kColor:
          store_component(colors_.type, value,
                          face_color_.data() + components_[property] * component_size(colors_.type));
          break;
        case Role::kNone:
          break;
      }
      return nullptr;
    };
    for (std::uint64_t f = 0; f < face.count; ++f) {
      corners_.clear();
      face_uvs_.clear();
      DELTAMESH_CHECK(body.read_row(face, take));
      DELTAMESH_CHECK(end_row(body));
    }
    return {};
  }

  /// Colours are left out where `mesh` has some at its vertices.
  void move_into(PolygonMesh& mesh, ReadReport& report) {
    for (const LeftOut& entry : report_.left_out) report.leave_out(entry.kind, entry.name, entry.count);
    const bool has_colors = std::any_of(mesh.attributes.begin(), mesh.attributes.end(),
                                        [](const Attribute& a) { return a.kind == AttributeKind::kColor; });
    if (has_colors && !face_color_.empty())
      report.leave_out(LeftOutKind::kFaceValues, "colours, for the vertices have some", faces_.count());
    if (!has_colors && !face_color_.empty())
      mesh.corner_values.push_back(index_values(std::move(colors_), color_owners_));
    if (!uvs_.values.empty()) {
      report.leave_out(LeftOutKind::kGuesses, "0 0 as texture coordinates of corners without",
                       corners_without_uvs_);
      mesh.corner_values.push_back(index_values(std::move(uvs_), uv_owners_));
    }
    mesh.faces = std::move(faces_);
  }

 private:
  enum class Role : std::uint8_t { kNone, kCorners, kUvs, kColor };

  /// What each property is; `report_` gets those that are nothing.
  void choose_roles(const PlyElement& face) {
    PlyLayout layout = layout_ply_element(face);
    roles_.resize(face.properties.size());
    components_.resize(face.properties.size());
    const auto color = std::find_if(layout.attributes.begin(), layout.attributes.end(),
                                    [](const Attribute& a) { return a.kind == AttributeKind::kColor; });
    const auto color_number = static_cast<std::size_t>(color - layout.attributes.begin());
    bool has_corners = false;
    for (std::size_t p = 0; p < roles_.size(); ++p) {
      const PlyProperty& property = face.properties[p];
      const PlyTarget& target = layout.targets[p];
      const bool corners = property.name == "vertex_indices" || property.name == "vertex_index";
      if (property.is_list && corners && !has_corners) {
        roles_[p] = Role::kCorners;
        has_corners = true;
      } else if (property.is_list && property.name == "texcoord" && !has_uvs_) {
        roles_[p] = Role::kUvs;
        has_uvs_ = true;
      } else if (target.kind == PlyTarget::Kind::kAttribute && target.attribute == color_number) {
        roles_[p] = Role::kColor;
        components_[p] = target.component;
      } else {
        report_.leave_out(LeftOutKind::kFaceValues, property.name, face.count);
      }
    }
    if (color != layout.attributes.end()) {
      colors_ = std::move(*color);
      face_color_.resize(colors_.components * component_size(colors_.type));
    }
    uvs_ = make_attribute(AttributeKind::kUv, ComponentType::kF32, 2, "texcoord", 0);
  }
  Result<void> end_row(const PlyBody& body) {
    if (!face_uvs_.empty() && face_uvs_.size() != 2 * corners_.size())
      return body.at("PLY: a list texcoord that has not two numbers for each corner");
    if (!faces_.add(corners_)) return {};
    if (!face_color_.empty()) {
      color_owners_.insert(color_owners_.end(), corners_.size(),
                           static_cast<std::uint32_t>(faces_.count() - 1));
      colors_.values.insert(colors_.values.end(), face_color_.begin(), face_color_.end());
    }
    const std::size_t value = 2 * sizeof(float);
    for (std::size_t c = 0; has_uvs_ && c < corners_.size(); ++c) {
      if (face_uvs_.empty()) ++corners_without_uvs_;
      uv_owners_.push_back(face_uvs_.empty() ? CornerValues::kNone
                                             : static_cast<std::uint32_t>(uvs_.values.size() / value));
      if (face_uvs_.empty()) continue;
      const std::array<float, 2> uv{to_float(face_uvs_[2 * c]), to_float(face_uvs_[2 * c + 1])};
      const auto bytes = std::as_bytes(std::span(uv));
      uvs_.values.insert(uvs_.values.end(), bytes.begin(), bytes.end());
    }
    return {};
  }

  Faces faces_;
  std::vector<Role> roles_;
  ReadReport report_;
  std::vector<std::uint32_t> corners_;  // of this face
  std::vector<double> face_uvs_;
  std::vector<std::byte> face_color_;
  std::vector<std::uint8_t> components_;  // of the colour, for every property
  Attribute colors_;                      // one per face
  std::vector<std::uint32_t> color_owners_;
  bool has_uvs_ = false;
  Attribute uvs_;  // one per corner that has them
  std::vector<std::uint32_t> uv_owners_;
  std::uint64_t corners_without_uvs_ = 0;
};

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
