// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/ply/faces.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "base/try.h"
#include "io/components.h"

namespace deltamesh {

void PlyFaces::choose_roles(const PlyElement& face) {
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

Result<void> PlyFaces::read(PlyBody& body, const PlyElement& face, std::uint64_t vertices) {
  choose_roles(face);
  if (std::find(roles_.begin(), roles_.end(), Role::kCorners) == roles_.end())
    return body.at("PLY: the faces have no list vertex_indices");
  constexpr const char* kMissing = "PLY: a face names a vertex that does not exist";
  const auto take = [&](std::size_t property, double value) -> const char* {
    switch (roles_[property]) {
      case Role::kCorners:
        if (!(value >= 0 && value < static_cast<double>(vertices))) return kMissing;
        corners_.push_back(static_cast<std::uint32_t>(value));
        if (static_cast<double>(corners_.back()) != value) return kMissing;
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

Result<void> PlyFaces::end_row(const PlyBody& body) {
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

void PlyFaces::move_into(PolygonMesh& mesh, ReadReport& report) {
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

}  // namespace deltamesh
