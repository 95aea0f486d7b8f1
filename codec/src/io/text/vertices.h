// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Shared by the writers of text formats: world positions, and the attributes of a view by their role.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

#include "deltamesh/io.h"
#include "io/components.h"
#include "io/text/numbers.h"

namespace deltamesh {

/// Whether world coordinates need doubles.
inline bool has_origin(const MeshView& mesh) noexcept {
  return std::any_of(mesh.origin.begin(), mesh.origin.end(), [](double o) { return o != 0; });
}

inline double world_coordinate(const MeshView& mesh, std::size_t vertex, std::size_t axis) noexcept {
  return mesh.origin[axis] + static_cast<double>(mesh.positions[3 * vertex + axis]);
}

/// Appends "x y z" in shortest digits: of the float where there is no origin, else of the double.
inline void append_position(std::string& out, const MeshView& mesh, std::size_t vertex) {
  const bool wide = has_origin(mesh);
  for (std::size_t k = 0; k < 3; ++k) {
    if (k > 0) out += ' ';
    if (wide)
      append_number(out, world_coordinate(mesh, vertex, k));
    else
      append_number(out, mesh.positions[3 * vertex + k]);
  }
}

/// The first attribute of `kind` with at least `components` components, or nullptr.
inline const AttributeView* first_of(const MeshView& mesh, AttributeKind kind,
                                     std::size_t components) noexcept {
  const auto found =
      std::find_if(mesh.attributes.begin(), mesh.attributes.end(), [=](const AttributeView& attribute) {
        return attribute.kind == kind && attribute.components >= components;
      });
  return found == mesh.attributes.end() ? nullptr : &*found;
}

/// The attributes that text formats have places for.
struct VertexValues {
  const AttributeView* normal = nullptr;
  const AttributeView* color = nullptr;
  const AttributeView* uv = nullptr;
};

/// The first of each; `report` gets all others, and what loses digits.
inline VertexValues choose_values(const MeshView& mesh, WriteReport& report) {
  const VertexValues chosen{first_of(mesh, AttributeKind::kNormal, 3),
                            first_of(mesh, AttributeKind::kColor, 3), first_of(mesh, AttributeKind::kUv, 2)};
  for (const AttributeView& attribute : mesh.attributes) {
    const bool taken = &attribute == chosen.normal || &attribute == chosen.color || &attribute == chosen.uv;
    if (!taken) report.leave_out(LeftOutKind::kVertexValues, attribute.name, mesh.vertex_count());
    if (taken && attribute.type == ComponentType::kF64)
      report.leave_out(LeftOutKind::kPrecision, attribute.name, mesh.vertex_count());
  }
  return chosen;
}

/// For formats that have no groups of faces.
inline void leave_out_groups(const MeshView& mesh, WriteReport& report) {
  report.leave_out(LeftOutKind::kFaceValues, "groups", mesh.face_groups.size());
  report.leave_out(LeftOutKind::kNames, "groups", mesh.group_names.size());
}

/// Component `c` of a vertex, integers of a normalized attribute scaled to [0, 1] or [-1, 1].
inline double attribute_value(const AttributeView& attribute, std::size_t vertex, std::size_t c) noexcept {
  const std::size_t at = (vertex * attribute.components + c) * component_size(attribute.type);
  return load_normalized(attribute.type, attribute.normalized, attribute.values.data() + at);
}

/// Appends the first `count` components of a vertex as shortest floats, each after a blank.
inline void append_values(std::string& out, const AttributeView& attribute, std::size_t vertex,
                          std::size_t count) {
  for (std::size_t c = 0; c < count; ++c) {
    out += ' ';
    append_number(out, to_float(attribute_value(attribute, vertex, c)));
  }
}

}  // namespace deltamesh
