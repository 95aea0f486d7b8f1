// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/gltf/content/narrow.h"

#include <array>
#include <cmath>

#include "io/components.h"

namespace deltamesh {
namespace {

double value_of(const AttributeView& attribute, std::size_t i) noexcept {
  return load_normalized(attribute.type, attribute.normalized,
                         &attribute.values[i * component_size(attribute.type)]);
}

/// Whether every value is a whole number that `type` holds.
bool holds_all(ComponentType type, const AttributeView& attribute, std::size_t numbers) {
  std::array<std::byte, sizeof(double)> stored{};
  for (std::size_t i = 0; i < numbers; ++i) {
    const double value = value_of(attribute, i);
    if (!store_component(type, value, stored.data()) || load_component(type, stored.data()) != value)
      return false;
    if (value == 0 && std::signbit(value)) return false;
  }
  return true;
}

}  // namespace

AttributeView with_gltf_type(const AttributeView& attribute, std::vector<Attribute>& kept,
                             WriteReport& report) {
  if (component_size(attribute.type) <= 2 || attribute.type == ComponentType::kF32) return attribute;
  const std::size_t numbers = attribute.values.size() / component_size(attribute.type);
  ComponentType type = ComponentType::kF32;
  for (const ComponentType narrow :
       {ComponentType::kI16, ComponentType::kU16, ComponentType::kI8, ComponentType::kU8})
    if (holds_all(narrow, attribute, numbers)) type = narrow;
  const std::size_t rows = numbers / attribute.components;
  kept.push_back(make_attribute(AttributeKind::kGeneric, type, attribute.components, {}, rows));
  std::vector<std::byte>& bytes = kept.back().values;
  std::uint64_t changed = 0;
  for (std::size_t v = 0; v < rows; ++v) {
    bool same = true;
    for (std::size_t i = v * attribute.components; i < (v + 1) * attribute.components; ++i) {
      const double value = value_of(attribute, i);
      std::byte* const to = &bytes[i * component_size(type)];
      store_component(type, value, to);
      same = same && (load_component(type, to) == value || std::isnan(value));
    }
    changed += same ? 0 : 1;
  }
  report.leave_out(LeftOutKind::kPrecision, attribute.name, changed);
  AttributeView view = attribute;
  view.type = type;
  view.normalized = false;
  view.values = bytes;
  return view;
}

Vec3 unit_direction(const AttributeView& attribute, std::size_t vertex, const Vec3& otherwise) noexcept {
  constexpr double kTolerance = 1e-4;
  Vec3 value{};
  for (std::size_t k = 0; k < 3; ++k) value[k] = value_of(attribute, vertex * attribute.components + k);
  const double size = length(value);
  if (!(size > 0) || !std::isfinite(size)) return otherwise;
  return std::fabs(size - 1) > kTolerance ? (1 / size) * value : value;
}

}  // namespace deltamesh
