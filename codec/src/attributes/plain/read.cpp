// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <array>
#include <bit>
#include <cmath>
#include <utility>

#include "attributes/plain/levels.h"
#include "attributes/plain/octahedral.h"
#include "attributes/plain/plain.h"
#include "attributes/plain/symbols.h"
#include "attributes/values.h"
#include "base/byte_reader.h"
#include "base/try.h"
#include "format/chunk/tags.h"

namespace deltamesh {
namespace {

using Symbols = std::vector<std::uint64_t>;

Result<int> read_bits(ByteReader& in, int min, int max) {
  DELTAMESH_TRY(const auto bits, in.read<std::uint8_t>());
  if (bits < min || bits > max) return in.invalid("attribute bits out of range", "ATTR-2");
  return static_cast<int>(bits);
}

/// Reads all components; `bits_of(c, symbol)` is what a symbol stands for.
template <class BitsOf>
Result<void> read_components(ByteReader& in, const Attribute& shape, std::uint32_t rows, int bits,
                             AttributeValues& values, BitsOf bits_of) {
  Symbols before;
  for (std::size_t c = 0; c < shape.components; ++c) {
    DELTAMESH_TRY(Symbols symbols, read_symbols(in, rows, before, static_cast<unsigned>(bits)));
    values.set_component(c, [&](std::size_t i) { return bits_of(c, symbols[i]); });
    before = std::move(symbols);
  }
  return {};
}

std::uint64_t bits_of_float(float number) noexcept { return std::bit_cast<std::uint32_t>(number); }

Result<void> read_normals(ByteReader& in, std::uint32_t rows, AttributeValues& values) {
  DELTAMESH_TRY(const int bits, read_bits(in, 2, 15));
  DELTAMESH_TRY(const Symbols u, read_symbols(in, rows, {}, static_cast<unsigned>(bits)));
  DELTAMESH_TRY(const Symbols v, read_symbols(in, rows, u, static_cast<unsigned>(bits)));
  const std::uint32_t zero = octahedral_zero(bits);
  for (std::size_t i = 0; i < rows; ++i) {
    const OctahedralCode code{static_cast<std::uint32_t>(u[i]), static_cast<std::uint32_t>(v[i])};
    if ((code[0] == zero) != (code[1] == zero))
      return in.invalid("octahedral code outside its square", "ATTR-5");
    const auto normal = decode_octahedral(code, bits);
    for (std::size_t c = 0; c < 3; ++c) values.set(i, c, bits_of_float(normal[c]));
  }
  return {};
}

Result<void> read_colors(ByteReader& in, const Attribute& shape, std::uint32_t rows,
                         AttributeValues& values) {
  const int full_bits = max_color_bits(shape.type);
  DELTAMESH_TRY(const int bits, read_bits(in, 1, full_bits));
  const std::uint32_t top = top_level(bits);
  const bool is_float = shape.type == ComponentType::kF32;
  return read_components(in, shape, rows, bits, values, [&](std::size_t, std::uint64_t symbol) {
    const auto level = static_cast<std::uint32_t>(symbol);
    return is_float ? bits_of_float(value_of(level, LevelRange{}, top))
                    : rescale_level(level, top, top_level(full_bits));
  });
}

Result<void> read_uvs(ByteReader& in, const Attribute& shape, std::uint32_t rows, AttributeValues& values) {
  DELTAMESH_TRY(const int bits, read_bits(in, 1, 24));
  std::array<LevelRange, 2> ranges;
  for (LevelRange& range : ranges) {
    DELTAMESH_TRY(range.min, in.read<float>());
    DELTAMESH_TRY(range.max, in.read<float>());
    if (!std::isfinite(range.min) || !std::isfinite(range.max) || range.min > range.max)
      return in.invalid("range of texture coordinates is not one", "ATTR-7");
  }
  return read_components(in, shape, rows, bits, values, [&](std::size_t c, std::uint64_t symbol) {
    return bits_of_float(value_of(static_cast<std::uint32_t>(symbol), ranges[c], top_level(bits)));
  });
}

Result<void> read_coded(ByteReader& in, AttributeCoding coding, const Attribute& shape, std::uint32_t rows,
                        AttributeValues& values) {
  switch (coding) {
    case AttributeCoding::kExact:
      return read_components(in, shape, rows, static_cast<int>(8 * component_size(shape.type)), values,
                             [](std::size_t, std::uint64_t symbol) { return symbol; });
    case AttributeCoding::kOctahedral:
      return read_normals(in, rows, values);
    case AttributeCoding::kColorLevels:
      return read_colors(in, shape, rows, values);
    case AttributeCoding::kUvLevels:
      return read_uvs(in, shape, rows, values);
    default:
      return in.invalid("a compact attribute coding in a plain payload", "ATTR-2");
  }
}

}  // namespace

Result<std::vector<std::byte>> read_plain_values(std::span<const std::byte> payload, const Attribute& shape,
                                                 std::uint32_t rows) {
  ByteReader in(payload, kTagAttribute);
  DELTAMESH_TRY(const auto coding, in.read<std::uint8_t>());
  AttributeValues values(shape.type, shape.components, rows);
  DELTAMESH_CHECK(read_coded(in, static_cast<AttributeCoding>(coding), shape, rows, values));
  DELTAMESH_CHECK(in.finish());
  return values.take();
}

}  // namespace deltamesh
