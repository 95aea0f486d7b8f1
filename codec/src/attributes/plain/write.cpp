// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "attributes/error.h"
#include "attributes/plain/levels.h"
#include "attributes/plain/octahedral.h"
#include "attributes/plain/plain.h"
#include "attributes/plain/symbols.h"
#include "base/byte_writer.h"

namespace deltamesh {
namespace {

bool all_unit_or_zero(const AttributeRows& rows) {
  for (std::size_t i = 0; i < rows.count(); ++i) {
    const Vec3 vector = rows.vector(i);
    if (vector != Vec3{} && !is_direction(vector)) return false;
  }
  return true;
}

/// Smallest and largest value of a component. False where one is not finite.
bool find_range(const AttributeRows& rows, std::size_t component, LevelRange& range) {
  if (rows.count() != 0) range = {rows.number(0, component), rows.number(0, component)};
  for (std::size_t i = 0; i < rows.count(); ++i) {
    const float value = rows.number(i, component);
    if (!std::isfinite(value)) return false;
    range.min = std::min(range.min, value);
    range.max = std::max(range.max, value);
  }
  return true;
}

bool all_in_unit_range(const AttributeRows& rows) {
  LevelRange range;
  for (std::size_t c = 0; c < rows.components(); ++c)
    if (!find_range(rows, c, range) || range.min < 0 || range.max > 1) return false;
  return true;
}

using Symbols = std::vector<std::uint64_t>;

/// Writes all components; `symbol_of(i, c)` is what stands for component c of row i.
template <class SymbolOf>
void write_components(ByteWriter& out, std::size_t rows, std::size_t components, int bits,
                      SymbolOf symbol_of) {
  Symbols before;
  for (std::size_t c = 0; c < components; ++c) {
    Symbols symbols(rows);
    for (std::size_t i = 0; i < rows; ++i) symbols[i] = symbol_of(i, c);
    write_symbols(out, symbols, before, static_cast<unsigned>(bits));
    before = std::move(symbols);
  }
}

void write_coding(ByteWriter& out, AttributeCoding coding) { out.write(static_cast<std::uint8_t>(coding)); }

void write_normals(ByteWriter& out, const AttributeRows& rows, int bits) {
  write_coding(out, AttributeCoding::kOctahedral);
  out.write(static_cast<std::uint8_t>(bits));
  std::vector<OctahedralCode> codes(rows.count());
  for (std::size_t i = 0; i < codes.size(); ++i) codes[i] = encode_octahedral(rows.vector(i), bits);
  write_components(out, codes.size(), 2, bits, [&](std::size_t i, std::size_t c) { return codes[i][c]; });
}

void write_colors(ByteWriter& out, ComponentType type, const AttributeRows& rows, int bits) {
  write_coding(out, AttributeCoding::kColorLevels);
  out.write(static_cast<std::uint8_t>(bits));
  const std::uint32_t top = top_level(bits);
  const std::uint32_t full = top_level(max_color_bits(type));
  write_components(out, rows.count(), rows.components(), bits, [&](std::size_t i, std::size_t c) {
    return type == ComponentType::kF32
               ? level_of(rows.number(i, c), LevelRange{}, top)
               : rescale_level(static_cast<std::uint32_t>(rows.bits(i, c)), full, top);
  });
}

void write_uvs(ByteWriter& out, const AttributeRows& rows, const std::array<LevelRange, 2>& ranges,
               int bits) {
  write_coding(out, AttributeCoding::kUvLevels);
  out.write(static_cast<std::uint8_t>(bits));
  for (const LevelRange& range : ranges) {
    out.write(range.min);
    out.write(range.max);
  }
  write_components(out, rows.count(), 2, bits, [&](std::size_t i, std::size_t c) {
    return level_of(rows.number(i, c), ranges[c], top_level(bits));
  });
}

/// Of the payloads that `write(out, bits)` makes, that with the fewest bits from `first` to `last` whose
/// values, as a reader gets them, keep the bound.
template <class Write>
std::optional<std::vector<std::byte>> write_fewest_bits(const AttributeView& attribute,
                                                        const AttributeRows& rows, double bound, int first,
                                                        int last, Write write) {
  const Attribute shape{.kind = attribute.kind, .type = attribute.type, .components = attribute.components};
  for (int bits = first; bits <= last; ++bits) {
    ByteWriter out;
    write(out, bits);
    std::vector<std::byte> payload = out.take();
    const auto read = read_plain_values(payload, shape, static_cast<std::uint32_t>(rows.count()));
    if (read && attribute_error(attribute, rows, *read) <= bound) return payload;
  }
  return std::nullopt;
}

/// Within `bound`, above 0; empty where no coding of the kind does that.
std::optional<std::vector<std::byte>> write_levels(const AttributeView& attribute, const AttributeRows& rows,
                                                   double bound) {
  const auto fits = [&](AttributeCoding coding) {
    return coding_fits(coding, attribute.kind, attribute.type, attribute.components);
  };
  const auto fewest = [&](int first, int last, auto write) {
    return write_fewest_bits(attribute, rows, bound, first, last, write);
  };
  if (fits(AttributeCoding::kOctahedral) && all_unit_or_zero(rows))
    return fewest(2, 15, [&](ByteWriter& out, int bits) { write_normals(out, rows, bits); });
  if (fits(AttributeCoding::kColorLevels) &&
      (attribute.type != ComponentType::kF32 || all_in_unit_range(rows)))
    return fewest(1, max_color_bits(attribute.type),
                  [&](ByteWriter& out, int bits) { write_colors(out, attribute.type, rows, bits); });
  std::array<LevelRange, 2> ranges;
  if (fits(AttributeCoding::kUvLevels) && find_range(rows, 0, ranges[0]) && find_range(rows, 1, ranges[1]))
    return fewest(1, 24, [&](ByteWriter& out, int bits) { write_uvs(out, rows, ranges, bits); });
  return std::nullopt;
}

}  // namespace

std::vector<std::byte> write_plain_attribute(const AttributeView& attribute, const AttributeRows& rows,
                                             double bound) {
  if (bound > 0) {
    if (auto levels = write_levels(attribute, rows, bound)) return *std::move(levels);
  }
  return write_exact_attribute(attribute, rows);
}

std::vector<std::byte> write_exact_attribute(const AttributeView& attribute, const AttributeRows& rows) {
  ByteWriter out;
  write_coding(out, AttributeCoding::kExact);
  write_components(out, rows.count(), rows.components(), static_cast<int>(8 * component_size(attribute.type)),
                   [&](std::size_t i, std::size_t c) { return rows.bits(i, c); });
  return out.take();
}

}  // namespace deltamesh
