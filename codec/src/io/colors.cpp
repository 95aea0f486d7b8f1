// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/colors.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "base/numbers/srgb.h"
#include "io/components.h"

namespace deltamesh {
namespace {

bool is_color(const AttributeView& attribute) noexcept {
  return attribute.kind == AttributeKind::kColor && (attribute.components == 3 || attribute.components == 4);
}

std::size_t rows_of(const AttributeView& color) noexcept {
  return color.values.size() / (color.components * component_size(color.type));
}

/// Component `c` of row `i`, integers as parts of 1.
double part(const AttributeView& color, std::size_t i, std::size_t c) noexcept {
  const std::byte* const from = &color.values[(i * color.components + c) * component_size(color.type)];
  return load_component(color.type, from) / normalized_one(color.type);
}

/// `value` as a component of `type` holds it, and as it reads back.
double stored(ComponentType type, double value, std::byte* to) noexcept {
  const bool real = type == ComponentType::kF32;
  store_component(type, real ? value : std::clamp(value, 0.0, 1.0) * normalized_one(type) + 0.5, to);
  return load_component(type, to) / normalized_one(type);
}

/// The colours in the other space, as `type`. `changed`: counts the rows that the way back would change.
Attribute converted(const AttributeView& color, ComponentType type, std::uint64_t& changed) {
  const auto there = color.linear ? shown_of_linear : linear_of_shown;
  const auto back = color.linear ? linear_of_shown : shown_of_linear;
  const std::size_t rows = rows_of(color);
  const std::size_t size = component_size(type);
  Attribute result = make_attribute(AttributeKind::kColor, type, color.components, {}, rows);
  result.linear = !color.linear;
  std::byte* to = result.values.data();
  std::byte again[sizeof(double)];
  for (std::size_t i = 0; i < rows; ++i) {
    bool same = true;
    for (std::size_t c = 0; c < color.components; ++c, to += size) {
      const double before = part(color, i, c);
      const double after = stored(type, c < 3 ? there(before) : before, to);
      if (type != ComponentType::kF32)
        same &= stored(color.type, c < 3 ? back(after) : after, again) == before;
    }
    changed += same ? 0 : 1;
  }
  return result;
}

/// Keeps `color` and lets `view` show it.
void replace(AttributeView& view, Attribute color, std::vector<Attribute>& kept) {
  kept.push_back(std::move(color));
  const Attribute& now = kept.back();
  view.type = now.type;
  view.normalized = now.normalized;
  view.linear = now.linear;
  view.values = now.values;
}

}  // namespace

MeshView with_linear_colors(const MeshView& mesh, std::vector<Attribute>& kept) {
  MeshView view = mesh;
  for (AttributeView& color : view.attributes) {
    if (!is_color(color) || color.linear) continue;
    std::uint64_t changed = 0;  // none: 16 bits tell all bytes apart
    const ComponentType type = color.type == ComponentType::kU8 ? ComponentType::kU16 : ComponentType::kF32;
    replace(color, converted(color, type, changed), kept);
  }
  return view;
}

MeshView with_shown_colors(const MeshView& mesh, std::vector<Attribute>& kept, WriteReport& report) {
  MeshView view = mesh;
  for (AttributeView& color : view.attributes) {
    if (!is_color(color) || !color.linear) continue;
    const bool integer = color.type == ComponentType::kU8 || color.type == ComponentType::kU16;
    std::uint64_t changed = 0;
    Attribute shown = converted(color, integer ? ComponentType::kU8 : ComponentType::kF32, changed);
    if (changed > 0 && color.type == ComponentType::kU16) {
      changed = 0;
      shown = converted(color, ComponentType::kU16, changed);
    }
    report.leave_out(LeftOutKind::kPrecision, color.name, changed);
    replace(color, std::move(shown), kept);
  }
  return view;
}

void settle_range(Attribute& color, ReadReport& report) {
  if (color.kind != AttributeKind::kColor || color.type != ComponentType::kF32 || color.values.empty())
    return;
  constexpr float kBrightest = 16;
  std::vector<float> numbers(color.values.size() / sizeof(float));
  std::memcpy(numbers.data(), color.values.data(), color.values.size());
  float largest = 0;
  float alpha = 0;
  bool whole = true;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const float x = numbers[i];
    if (x < 0 || x > 255) return;
    float& most = i % color.components < 3 ? largest : alpha;
    most = std::fmax(most, x);
    whole = whole && x == std::floor(x);
  }
  if (!(largest > 1) || (!whole && largest < kBrightest)) return;
  const std::uint64_t rows = numbers.size() / color.components;
  report.leave_out(LeftOutKind::kGuesses, "255 as the brightest of colours", rows);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (alpha > 1 || i % color.components < 3) numbers[i] /= 255;
  std::memcpy(color.values.data(), numbers.data(), color.values.size());
  if (!whole) return;
  Attribute bytes = make_attribute(AttributeKind::kColor, ComponentType::kU8, color.components,
                                   std::move(color.name), rows);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    bytes.values[i] = static_cast<std::byte>(std::lround(255 * numbers[i]));
  color = std::move(bytes);
}

}  // namespace deltamesh
