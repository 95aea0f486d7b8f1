// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "adapt/attributes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <type_traits>

#include "base/component.h"
#include "support/errors.h"

namespace deltamesh {
namespace {

double number_at(const AttributeView& from, std::size_t i) {
  return load_component(from.type, from.values.data() + i * component_size(from.type));
}

/// False where the number is none of the type.
bool put_number(double value, Attribute& to, std::size_t i) {
  return with_component(to.type, [&](auto number) {
    using T = decltype(number);
    if constexpr (std::is_integral_v<T>) {
      const bool fits = value >= double{std::numeric_limits<T>::lowest()} &&
                        value <= double{std::numeric_limits<T>::max()} && std::trunc(value) == value;
      if (!fits) return false;
    } else if (std::isfinite(value) && std::abs(value) > double{std::numeric_limits<T>::max()}) {
      return false;
    }
    number = static_cast<T>(value);
    std::memcpy(to.values.data() + i * sizeof number, &number, sizeof number);
    return true;
  });
}

bool is_float(ComponentType type) { return type == ComponentType::kF32 || type == ComponentType::kF64; }

bool is_color_type(ComponentType type) {
  return is_float(type) || type == ComponentType::kU8 || type == ComponentType::kU16;
}

/// Null: it went well. Fills `to`, which has room.
const char* take_colors(const AttributeView& from, Attribute& to, std::size_t vertices) {
  if (from.linear != to.linear) return "colours are linear light where the map's are not, or the reverse";
  if (!is_color_type(from.type) || !is_color_type(to.type)) return "colours are u8, u16, f32 or f64";
  if (from.components < 3 || from.components > 4 || to.components < 3 || to.components > 4)
    return "colours have 3 or 4 components";
  const double full = normalized_one(to.type);
  for (std::size_t v = 0; v < vertices; ++v) {
    for (std::size_t c = 0; c < to.components; ++c) {
      double value = 1;
      if (c < from.components) value = number_at(from, v * from.components + c) / normalized_one(from.type);
      if (std::isnan(value)) return "a colour is NaN";
      value = full * std::clamp(value, 0.0, 1.0);
      put_number(is_float(to.type) ? value : std::floor(value + 0.5), to, v * to.components + c);
    }
  }
  return nullptr;
}

const char* take_values(const AttributeView& from, Attribute& to) {
  if (from.components != to.components) return "an attribute has not as many components as the map's";
  if (from.normalized != to.normalized)
    return "an attribute is normalized where the map's is not, or the reverse";
  if (from.type == to.type) {
    std::copy(from.values.begin(), from.values.end(), to.values.begin());
    return nullptr;
  }
  for (std::size_t i = 0; i < to.values.size() / component_size(to.type); ++i)
    if (!put_number(number_at(from, i), to, i)) return "a value does not fit the type of the map's attribute";
  return nullptr;
}

bool is_found_by_kind(AttributeKind kind) {
  return kind == AttributeKind::kColor || kind == AttributeKind::kNormal || kind == AttributeKind::kTangent;
}

bool is_the_maps(const AttributeView& from, const MapAttribute& to) {
  return from.kind == to.kind && (is_found_by_kind(to.kind) || from.name == to.name);
}

bool may_be_dropped(AttributeKind kind) {
  return kind == AttributeKind::kNormal || kind == AttributeKind::kTangent;
}

}  // namespace

Result<std::vector<Attribute>> adapt_attributes(const MeshView& mesh, const MapDescription& description) {
  std::vector<bool> taken(mesh.attributes.size());
  std::vector<Attribute> attributes;
  for (std::size_t i = 0; i < description.attributes.size(); ++i) {
    const MapAttribute& of = description.attributes[i];
    std::size_t found = 0;
    while (found < taken.size() && (taken[found] || !is_the_maps(mesh.attributes[found], of))) ++found;
    if (found == taken.size())
      return invalid_mesh("the block lacks an attribute of the map", WhereKind::kAttribute, i);
    taken[found] = true;
    Attribute& to = attributes.emplace_back(Attribute{.kind = of.kind,
                                                      .type = of.type,
                                                      .components = of.components,
                                                      .normalized = of.normalized,
                                                      .name = of.name,
                                                      .linear = of.linear});
    to.values.resize(mesh.vertex_count() * of.components * component_size(of.type));
    const AttributeView& from = mesh.attributes[found];
    const char* const fault =
        of.kind == AttributeKind::kColor ? take_colors(from, to, mesh.vertex_count()) : take_values(from, to);
    if (fault != nullptr) return invalid_mesh(fault, WhereKind::kAttribute, found);
  }
  for (std::size_t i = 0; i < taken.size(); ++i)
    if (!taken[i] && !may_be_dropped(mesh.attributes[i].kind))
      return invalid_mesh("the map has no such attribute", WhereKind::kAttribute, i);
  return attributes;
}

}  // namespace deltamesh
