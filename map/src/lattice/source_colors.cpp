// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "lattice/source_colors.h"

#include <algorithm>

#include "support/color_value.h"

namespace deltamesh {
namespace {

/// Larger ones would be seen as bands along borders.
constexpr double kMostErrorOfMean = 12;
/// More than what rounding to f32 adds to a difference of levels.
constexpr double kFloatRounding = 1.0 / 64;

/// Of types finer than levels, to which values are rounded first.
std::uint32_t step_of_levels(double most) noexcept {
  return static_cast<std::uint32_t>(std::max(2 * (most - kFloatRounding) - 1, 0.0));
}

BorderColors colors_of(const Attribute& source, std::uint32_t step, std::span<const BorderVertex> border,
                       std::span<const std::uint32_t> order) {
  BorderColors colors{.step = step};
  if (step == 0) return colors;
  const std::size_t size = component_size(source.type);
  for (const BorderVertex& vertex : border) {
    const std::byte* value =
        source.values.data() + std::size_t{order[vertex.vertex]} * source.components * size;
    for (std::size_t c = 0; c < source.components; ++c, value += size)
      colors.levels.push_back(color_level(source.type, value));
  }
  return colors;
}

}  // namespace

std::uint32_t border_step(ComponentType type, const AttributeQuality& quality) noexcept {
  const bool is_whole = type == ComponentType::kU8;
  if (quality.color_rms) {
    // Whatever the colours are, rounding is off by no more than the mean error.
    const double most = std::min(*quality.color_rms, kMostErrorOfMean);
    return is_whole ? 2 * static_cast<std::uint32_t>(most) + 1 : step_of_levels(most);
  }
  const double bound = std::min(quality.color_error.value_or(0), kMostBorderStep / 2.0);
  if (!is_whole) return step_of_levels(bound);
  return bound < 1 ? 0 : 2 * static_cast<std::uint32_t>(bound) + 1;
}

Mesh with_border_colors(const MapPart& part, const AttributeQuality& quality) {
  Mesh mesh = part.mesh;
  if (quality.color_rms) return mesh;
  for (Attribute& attribute : mesh.attributes) {
    const std::uint32_t step = is_color(attribute) ? border_step(attribute.type, quality) : 0;
    if (step == 0) continue;
    const std::size_t size = component_size(attribute.type);
    for (const BorderVertex& vertex : part.border) {
      std::byte* value = attribute.values.data() + std::size_t{vertex.vertex} * attribute.components * size;
      for (std::size_t c = 0; c < attribute.components; ++c, value += size)
        store_component(
            value, size,
            color_of_level(attribute.type, 8, border_level(color_level(attribute.type, value), step)));
    }
  }
  return mesh;
}

std::vector<BorderColors> border_colors(const Mesh& source, std::span<const BorderVertex> border,
                                        std::span<const std::uint32_t> order,
                                        const AttributeQuality& quality) {
  std::vector<BorderColors> colors;
  for (const Attribute& attribute : source.attributes)
    if (is_color(attribute))
      colors.push_back(colors_of(attribute, border_step(attribute.type, quality), border, order));
  return colors;
}

}  // namespace deltamesh
