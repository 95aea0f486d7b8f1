// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/colors/coder.h"
#include "attributes/colors/colors.h"
#include "attributes/colors/fields.h"
#include "base/byte_reader.h"
#include "base/small_code.h"
#include "base/try.h"
#include "entropy/coder/held_coder.h"
#include "entropy/coder/reader.h"
#include "format/chunk/tags.h"

namespace deltamesh {
namespace {

Result<ColorFields> read_fields(ByteReader& in, ComponentType type, unsigned components) {
  const auto invalid = [&](const char* message) { return in.invalid(message, "ATTR-45"); };
  ColorFields fields;
  fields.components = components;
  DELTAMESH_TRY(fields.bits, in.read<std::uint8_t>());
  if (!color_bits_fit(type, fields.bits))
    return invalid("bits of colour levels that their type does not allow");
  DELTAMESH_TRY(fields.bound, in.read<std::uint16_t>());
  const std::int32_t top = top_color_level(fields.bits);
  if (fields.bound > top / 2) return invalid("a parameter of the attribute is out of range");
  for (std::size_t c = 0; c < components; ++c) {
    ColorSource& source = fields.sources[c];
    DELTAMESH_TRY(source.component, in.read<std::uint8_t>());
    if (source.component == kConstantComponent) {
      DELTAMESH_TRY(source.level, in.read<std::uint16_t>());
      if (source.level > top) return invalid("a parameter of the attribute is out of range");
    } else if (source.component > c || !fields.is_coded(source.component)) {
      return invalid("colour component from one that is not coded");
    }
  }
  return fields;
}

}  // namespace

DELTAMESH_APART Result<std::vector<std::byte>> read_surface_colors(std::span<const std::byte> bytes,
                                                                   ComponentType type, unsigned components,
                                                                   const AttributeSurface& surface,
                                                                   const Learning<ColorModels>& learning,
                                                                   const Attribute* known) {
  constexpr std::uint32_t kVerticesAtOnce = 1024;
  ByteReader in(bytes, kTagAttribute);
  DELTAMESH_TRY(const ColorFields fields, read_fields(in, type, components));
  const ColorAxes axes = axes_of(fields);
  const std::uint32_t rows = surface.vertex_count();
  AttributeValues values(type, components, rows);
  if (axes.count == 0) {
    DELTAMESH_CHECK(in.finish());
    for (std::uint32_t v = 0; v < rows; ++v) set_color(values, v, type, fields, axes, {});
    return values.take();
  }
  DELTAMESH_TRY(const auto stream, in.read_bytes(in.remaining()));
  CompactReader first_reader(stream);
  ColorCoder<CompactReader> coder(first_reader, surface, shape_of(fields, axes), false, learning.start,
                                  former_colors(surface, known, fields, axes));
  Held<CompactReader> reader = first_reader;
  for (std::uint32_t v = 0; v < rows; ++v) {
    if (v % kVerticesAtOnce == 0 && reader.failed()) break;
    ColorLevels levels{};
    coder.code_vertex(reader, v, levels);
    set_color(values, v, type, fields, axes, levels);
  }
  DELTAMESH_CHECK(reader.finish(kTagAttribute));
  if (learning.end != nullptr) *learning.end = coder.models();
  return values.take();
}

}  // namespace deltamesh
