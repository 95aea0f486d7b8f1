// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "attributes/colors/coder.h"
#include "attributes/colors/colors.h"
#include "attributes/colors/fields.h"
#include "base/byte_writer.h"
#include "entropy/coder/writer.h"

namespace deltamesh {
namespace {

/// The levels of all rows; empty where a component has none.
std::optional<std::vector<ColorLevels>> levels_of(ComponentType type, const AttributeRows& rows,
                                                  unsigned bits) {
  std::vector<ColorLevels> levels(rows.count());
  for (std::size_t i = 0; i < levels.size(); ++i) {
    for (std::size_t c = 0; c < rows.components(); ++c) {
      const auto level = nearest_color_level(type, bits, static_cast<std::uint32_t>(rows.bits(i, c)));
      if (!level) return std::nullopt;
      levels[i][c] = *level;
    }
  }
  return levels;
}

/// Whether the levels stand for the colours' bits.
bool are_exact(ComponentType type, const AttributeRows& rows, unsigned bits,
               const std::vector<ColorLevels>& levels) {
  for (std::size_t i = 0; i < levels.size(); ++i)
    for (std::size_t c = 0; c < rows.components(); ++c)
      if (color_of_level(type, bits, levels[i][c]) != rows.bits(i, c)) return false;
  return true;
}

/// Levels, and how far they may be off.
struct Levels {
  unsigned bits;
  std::int32_t bound;
  std::vector<ColorLevels> levels;
};

/// More than what rounding to f32 adds to a difference of levels.
constexpr double kFloatRounding = 1.0 / 64;

/// Empty where nothing keeps the bound. Values between levels lose up to half a level by rounding.
std::optional<Levels> choose_levels(ComponentType type, const AttributeRows& rows, double max_error) {
  for (const unsigned bits : {8U, 16U}) {
    if (!color_bits_fit(type, bits)) continue;
    auto levels = levels_of(type, rows, bits);
    if (!levels) return std::nullopt;
    const std::int32_t top = top_color_level(bits);
    const double allowed = max_error * (top / 255.0);
    const auto with = [&](double bound) {
      const double most = top / 2.0;
      return Levels{bits, static_cast<std::int32_t>(std::min(bound, most)), *std::move(levels)};
    };
    const double whole = std::floor(allowed);
    const bool has_room = whole == 0 || type != ComponentType::kF32 || allowed - whole > kFloatRounding;
    if (has_room && are_exact(type, rows, bits, *levels)) return with(whole);
    if (bits == 16 && allowed >= 0.5 + kFloatRounding)
      return with(std::floor(allowed - (0.5 + kFloatRounding)));
  }
  return std::nullopt;
}

ColorFields find_fields(const Levels& source, unsigned components) {
  ColorFields fields{.bits = source.bits,
                     .bound = static_cast<std::uint16_t>(source.bound),
                     .components = components,
                     .sources = {}};
  const auto all = [&](auto test) { return std::all_of(source.levels.begin(), source.levels.end(), test); };
  for (std::size_t c = 0; c < components; ++c) {
    ColorSource& from = fields.sources[c];
    from.component = static_cast<std::uint8_t>(c);
    const std::int32_t first = source.levels.empty() ? 0 : source.levels[0][c];
    if (all([&](const ColorLevels& levels) { return levels[c] == first; })) {
      from = {.component = kConstantComponent, .level = static_cast<std::uint16_t>(first)};
      continue;
    }
    for (std::size_t d = 0; d < c && fields.is_coded(c); ++d)
      if (fields.is_coded(d) && all([&](const ColorLevels& levels) { return levels[c] == levels[d]; }))
        from.component = static_cast<std::uint8_t>(d);
  }
  return fields;
}

/// Whether at least a fifth of the vertices have the colour of a neighbour before them, within the bound:
/// else looking for copies costs readers more time than it saves.
bool copies_pay(const std::vector<ColorLevels>& levels, std::int32_t bound, const Adjacency& graph) {
  const auto are_near = [&](const ColorLevels& a, const ColorLevels& b) {
    bool near = true;
    for (std::size_t c = 0; c < kColorAxes; ++c) near = near && std::abs(a[c] - b[c]) <= bound;
    return near;
  };
  std::size_t repeated = 0;
  for (std::uint32_t v = 0; v < levels.size(); ++v) {
    const auto begin = graph.neighbors.begin() + graph.offsets[v];
    const auto end = graph.neighbors.begin() + graph.offsets[v + 1];
    repeated +=
        std::any_of(begin, end, [&](std::uint32_t u) { return u < v && are_near(levels[u], levels[v]); });
  }
  return repeated >= levels.size() / 5;
}

void write_fields(ByteWriter& out, const ColorFields& fields) {
  out.write(static_cast<std::uint8_t>(fields.bits));
  out.write(fields.bound);
  for (std::size_t c = 0; c < fields.components; ++c) {
    out.write(fields.sources[c].component);
    if (fields.sources[c].component == kConstantComponent) out.write(fields.sources[c].level);
  }
}

}  // namespace

std::optional<CodedValues<std::byte>> write_surface_colors(ComponentType type, const AttributeRows& rows,
                                                           double max_error, const AttributeSurface& surface,
                                                           const ColorModels* start, const Attribute* known,
                                                           double former_error) {
  const auto source = choose_levels(type, rows, max_error);
  if (!source) return std::nullopt;
  const ColorFields fields = find_fields(*source, static_cast<unsigned>(rows.components()));
  const ColorAxes axes = axes_of(fields);
  ByteWriter out;
  write_fields(out, fields);
  AttributeValues values(type, rows.components(), rows.count());
  CompactWriter writer;
  std::optional<ColorCoder<CompactWriter>> coder;
  if (axes.count > 0) {
    auto former = former_colors(surface, known, fields, axes);
    const double former_bound = former_error * (top_color_level(fields.bits) / 255.0);
    const bool has_copies = !former.empty() || copies_pay(source->levels, source->bound, surface.graph());
    coder.emplace(writer, surface, shape_of(fields, axes), has_copies, start, std::move(former),
                  static_cast<float>(std::max<double>(former_bound, source->bound)));
  }
  for (std::uint32_t v = 0; v < rows.count(); ++v) {
    ColorLevels by_axis{};
    for (std::size_t a = 0; a < axes.count; ++a) by_axis[a] = source->levels[v][axes.components[a]];
    if (coder) coder->code_vertex(writer, v, by_axis);
    set_color(values, v, type, fields, axes, by_axis);
  }
  if (coder) out.write_bytes(writer.finish());
  return CodedValues<std::byte>{.bytes = out.take(), .values = values.take()};
}

}  // namespace deltamesh
