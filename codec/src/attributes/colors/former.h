// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Colours that vertices had in a version that a reader has, as levels by axis [MAP-30].
#pragma once

#include <cstddef>
#include <cstdint>

#include "attributes/attribute.h"
#include "attributes/colors/fields.h"
#include "attributes/surface.h"
#include "attributes/values.h"
#include "base/memory/large_vector.h"

namespace deltamesh {

struct FormerColor {
  FourFloats levels{};
  bool is_there = false;
};

/// n; empty where nothing is known. `attribute`: of the known mesh, of the same shape, or null.
inline LargeVector<FormerColor> former_colors(const AttributeSurface& surface, const Attribute* attribute,
                                              const ColorFields& fields, const ColorAxes& axes) {
  LargeVector<FormerColor> former;
  if (attribute == nullptr || !surface.has_known()) return former;
  const std::size_t size = component_size(attribute->type);
  former.resize(surface.vertex_count(), FormerColor{});
  for (std::uint32_t v = 0; v < former.size(); ++v) {
    const std::uint32_t known = surface.known_of(v);
    if (known == kNoKnownVertex) continue;
    former[v].is_there = true;
    const std::byte* const row = attribute->values.data() + std::size_t{known} * fields.components * size;
    for (unsigned a = 0; a < axes.count; ++a) {
      const auto bits = static_cast<std::uint32_t>(load_component(row + axes.components[a] * size, size));
      former[v].levels[static_cast<int>(a)] =
          static_cast<float>(nearest_color_level(attribute->type, fields.bits, bits).value_or(0));
    }
  }
  return former;
}

}  // namespace deltamesh
