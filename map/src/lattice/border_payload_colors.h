// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The colours in a coded border [MAP-24]. One template for both directions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "attributes/colors/fields.h"
#include "attributes/values.h"
#include "lattice/border_colors.h"
#include "lattice/border_payload.h"
#include "support/color_value.h"

namespace deltamesh {

/// Of one attribute. `wanted`: none for readers.
template <class Coder>
void code_colors(Coder& coder, BorderColorModels& models, std::uint32_t step, Attribute& colors,
                 std::span<const BorderVertex> border, std::span<const std::uint8_t> wanted) {
  BorderColorCoder color_coder(coder, models, step);
  const std::size_t size = component_size(colors.type);
  std::size_t next = 0;
  for (const BorderVertex& vertex : border) {
    color_coder.begin_vertex();
    std::byte* value = colors.values.data() + vertex.vertex * colors.components * size;
    for (std::size_t c = 0; c < colors.components; ++c, value += size, ++next)
      store_component(value, size,
                      color_of_level(colors.type, 8,
                                     color_coder.code(color_level(colors.type, value),
                                                      Coder::kWrites ? wanted[next] : std::uint8_t{0})));
  }
}

/// Of all attributes that are colours. False where a step is too large.
template <class Coder>
bool code_all_colors(Coder& coder, BorderColorModels& models, Mesh& mesh,
                     std::span<const BorderVertex> border, std::span<const BorderColors> wanted) {
  std::size_t next = 0;
  const BorderColors none;
  for (Attribute& attribute : mesh.attributes) {
    if (!is_color(attribute)) continue;
    const BorderColors& colors = next < wanted.size() ? wanted[next] : none;
    ++next;
    const std::uint32_t step = coder.number(colors.step, models.step);
    if (step > kMostBorderStep) return false;
    if (step > 0) code_colors(coder, models, step, attribute, border, colors.levels);
  }
  return true;
}

}  // namespace deltamesh
