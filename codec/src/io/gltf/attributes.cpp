// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/gltf/attributes.h"

#include <algorithm>
#include <cstring>
#include <string_view>
#include <utility>

#include "base/try.h"
#include "io/components.h"
#include "io/io_error.h"
#include "io/names.h"

namespace deltamesh::gltf {
namespace {

/// What an attribute looks like over all sets.
struct Layout {
  AttributeKind kind = AttributeKind::kGeneric;
  ComponentType type = ComponentType::kF32;
  std::uint8_t components = 1;
  bool normalized = false;
  bool differs = false;  ///< type or shape is not the same in all sets
  std::size_t sets = 0;  ///< how many have it
};

AttributeKind kind_of(std::string_view semantic) noexcept {
  if (semantic == "NORMAL") return AttributeKind::kNormal;
  if (semantic == "TANGENT") return AttributeKind::kTangent;
  if (semantic.starts_with("COLOR_")) return AttributeKind::kColor;
  if (semantic.starts_with("TEXCOORD_")) return AttributeKind::kUv;
  if (semantic.starts_with("JOINTS_")) return AttributeKind::kJoints;
  if (semantic.starts_with("WEIGHTS_")) return AttributeKind::kWeights;
  return AttributeKind::kGeneric;
}

/// Whether a semantic of this kind can have the accessor's type and shape.
bool fits(AttributeKind kind, const AccessorShape& shape) noexcept {
  const bool real = shape.type == ComponentType::kF32;
  const bool natural = shape.type == ComponentType::kU8 || shape.type == ComponentType::kU16;
  const bool part_of_one = real || (natural && shape.normalized);
  if (shape.is_matrix) return kind == AttributeKind::kGeneric;
  switch (kind) {
    case AttributeKind::kNormal:
      return shape.components == 3;
    case AttributeKind::kColor:
      return part_of_one && (shape.components == 3 || shape.components == 4);
    case AttributeKind::kUv:
      return shape.components == 2;
    case AttributeKind::kTangent:
      return shape.components == 4;
    case AttributeKind::kJoints:
      return natural && !shape.normalized && shape.components == 4;
    case AttributeKind::kWeights:
      return part_of_one && shape.components == 4;
    case AttributeKind::kGeneric:
      break;
  }
  return true;
}

/// How one set has it, after the conversions that a kind always gets. Errors: kInvalidFile.
Result<Layout> layout_of(std::string_view semantic, const AccessorShape& shape) {
  Layout layout{.kind = kind_of(semantic),
                .type = shape.type,
                .components = shape.components,
                .normalized = shape.normalized,
                .differs = false,
                .sets = 1};
  if (!fits(layout.kind, shape))
    return invalid_file("glTF: an attribute of a type that its name cannot have");
  if (layout.kind == AttributeKind::kNormal || layout.kind == AttributeKind::kUv ||
      layout.kind == AttributeKind::kTangent) {
    layout.type = ComponentType::kF32;
    layout.normalized = false;
  }
  return layout;
}

void merge(const Layout& other, Layout& layout) noexcept {
  ++layout.sets;
  if (layout.type == other.type && layout.components == other.components &&
      layout.normalized == other.normalized)
    return;
  layout.differs = true;
  if (layout.kind == AttributeKind::kGeneric) return;
  layout.components = std::max(layout.components, other.components);
  if (layout.kind == AttributeKind::kJoints) {
    layout.type = ComponentType::kU16;
  } else if (layout.type != other.type) {
    layout.type = ComponentType::kF32;
    layout.normalized = false;
  }
}

using Layouts = std::map<std::string, Layout>;

Result<Layouts> find_layouts(const Document& document, const std::vector<VertexSet>& sets) {
  Layouts layouts;
  for (const VertexSet& set : sets) {
    for (const auto& [semantic, accessor] : set.semantics) {
      if (semantic == "POSITION") continue;
      DELTAMESH_TRY(const AccessorShape shape, plain_shape(document, accessor));
      if (shape.count != set.count)
        return accessor_error("the attributes of a primitive differ in their number of values", accessor);
      DELTAMESH_TRY(const Layout layout, layout_of(semantic, shape));
      const auto [known, is_new] = layouts.emplace(semantic, layout);
      if (!is_new) merge(layout, known->second);
    }
  }
  return layouts;
}

bool is_kept(const std::string& semantic, const Layout& layout, std::size_t sets) noexcept {
  if (!is_attribute_name(semantic)) return false;
  if (layout.kind != AttributeKind::kGeneric) return true;
  return layout.sets == sets && !layout.differs;
}

/// Value `c` of an element as `attribute` stores it.
void store(Attribute& attribute, std::uint64_t vertex, std::size_t c, double real) {
  const std::size_t size = component_size(attribute.type);
  if (attribute.normalized) real = real * normalized_one(attribute.type) + 0.5;
  store_component(attribute.type, real, attribute.values.data() + (vertex * attribute.components + c) * size);
}

/// Component `c` where a set does not have the attribute: opaque white, the tangent x, the normal z, else 0.
double missing_value(AttributeKind kind, std::size_t c) noexcept {
  if (kind == AttributeKind::kColor) return 1;
  if (kind == AttributeKind::kNormal) return c == 2 ? 1 : 0;
  return kind == AttributeKind::kTangent && (c == 0 || c == 3) ? 1 : 0;
}

/// Turns the first three components of float32 elements with the node.
void turn(Attribute& attribute, const VertexSet& set, bool tangent) {
  const bool mirrored = set.transform->determinant() < 0;
  for (std::uint64_t v = set.first; v < set.first + set.count; ++v) {
    std::byte* const at = attribute.values.data() + v * attribute.components * sizeof(float);
    float value[4] = {};
    std::memcpy(value, at, attribute.components * sizeof(float));
    Vec3 turned{value[0], value[1], value[2]};
    if (tangent) {
      const Vec3 direction = set.transform->direction(turned);
      const double size = length(direction);
      if (size > 0) turned = (1 / size) * direction;
      if (mirrored) value[3] = -value[3];  // the bitangent's side
    } else {
      turned = set.transform->normal(turned);
    }
    for (std::size_t k = 0; k < 3; ++k) value[k] = to_float(turned[k]);
    std::memcpy(at, value, attribute.components * sizeof(float));
  }
}

/// The same for people.
std::string missing_text(AttributeKind kind) {
  switch (kind) {
    case AttributeKind::kColor:
      return "white";
    case AttributeKind::kNormal:
      return "normals of the faces around";  // of vertices that faces use: read.cpp
    case AttributeKind::kTangent:
      return "1 0 0 1";
    default:
      return "0";
  }
}

void fill_missing(const VertexSet& set, Attribute& attribute, ReadReport& report) {
  report.leave_out(LeftOutKind::kGuesses,
                   missing_text(attribute.kind) + " as " + attribute.name + " of vertices without",
                   set.count);
  for (std::uint64_t v = set.first; v < set.first + set.count; ++v)
    for (std::size_t c = 0; c < attribute.components; ++c)
      store(attribute, v, c, missing_value(attribute.kind, c));
}

/// The values of one set.
void fill(const AccessorRows& rows, const VertexSet& set, Attribute& attribute) {
  const AccessorShape& shape = rows.shape();
  const std::size_t size = attribute.components * component_size(attribute.type);
  if (shape.type == attribute.type && shape.components == attribute.components) {
    for (std::uint64_t v = 0; v < set.count; ++v)
      std::memcpy(attribute.values.data() + (set.first + v) * size, rows.row(v).data(), size);
  } else {
    for (std::uint64_t v = 0; v < set.count; ++v)
      for (std::size_t c = 0; c < attribute.components; ++c) {
        // Three components widened to four: alpha is 1.
        const std::byte* const from = rows.row(v).data() + c * component_size(shape.type);
        store(attribute, set.first + v, c,
              c < shape.components ? load_normalized(shape.type, shape.normalized, from) : 1);
      }
  }
  const bool tangent = attribute.kind == AttributeKind::kTangent;
  if ((attribute.kind == AttributeKind::kNormal || tangent) && !set.transform->is_identity())
    turn(attribute, set, tangent);
}

}  // namespace

Result<AccessorShape> plain_shape(const Document& document, std::size_t accessor) {
  DELTAMESH_TRY(const auto shape, accessor_shape(document, accessor));
  if (!shape) return accessor_error("an accessor of a type that is not supported", accessor);
  return *shape;
}

Result<AccessorRows> plain_rows(const Document& document, std::size_t accessor) {
  DELTAMESH_CHECK(plain_shape(document, accessor));
  DELTAMESH_TRY(auto rows, read_accessor(document, accessor, kNoLimit));
  if (!rows)
    return accessor_error("the data of the accessor is in an extension that is not supported", accessor);
  return *std::move(rows);
}

Result<std::vector<Attribute>> merge_attributes(const Document& document, const std::vector<VertexSet>& sets,
                                                std::uint64_t vertices, ReadReport& report) {
  DELTAMESH_TRY(const Layouts layouts, find_layouts(document, sets));
  std::vector<Attribute> attributes;
  for (const auto& [semantic, layout] : layouts) {
    if (!is_kept(semantic, layout, sets.size())) {
      report.leave_out(LeftOutKind::kVertexValues, semantic, vertices);
      continue;
    }
    Attribute attribute = make_attribute(layout.kind, layout.type, layout.components, semantic, vertices);
    attribute.normalized = layout.normalized;
    attribute.linear = layout.kind == AttributeKind::kColor;
    for (const VertexSet& set : sets) {
      const auto own = set.semantics.find(semantic);
      if (own == set.semantics.end()) {
        fill_missing(set, attribute, report);
        continue;
      }
      DELTAMESH_TRY(const AccessorRows rows, plain_rows(document, own->second));
      fill(rows, set, attribute);
    }
    attributes.push_back(std::move(attribute));
  }
  return attributes;
}

}  // namespace deltamesh::gltf
