// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <array>
#include <bit>
#include <cmath>
#include <utility>

#include "attributes/levels.h"
#include "attributes/octahedral.h"
#include "attributes/plain_attribute.h"
#include "attributes/symbols.h"
#include "base/byte_reader.h"
#include "base/large_vector.h"
#include "base/try.h"
#include "format/tags.h"

namespace deltamesh {
namespace {

using Symbols = std::vector<std::uint64_t>;

Result<int> read_bits(ByteReader& in, int min, int max) {
  DELTAMESH_TRY(const auto bits, in.read<std::uint8_t>());
  if (bits < min || bits > max)
    return in.error(ErrorCode::kInvalidStream, "attribute bits out of range", "ATTR-2");
  return static_cast<int>(bits);
}

/// Writes decoded components into `Attribute::values`, row by row.
class Values {
 public:
  Values(Attribute& attribute, std::uint32_t rows)
      : values_(attribute.values), size_(component_size(attribute.type)), components_(attribute.components) {
    reserve_large(values_, rows * components_ * size_);
    values_.resize(rows * components_ * size_);
  }
  void set(std::size_t row, std::size_t component, std::uint64_t bits) noexcept {
    store_component(values_.data() + (row * components_ + component) * size_, size_, bits);
  }
  void set(std::size_t row, std::size_t component, float number) noexcept {
    set(row, component, std::uint64_t{std::bit_cast<std::uint32_t>(number)});
  }

 private:
  std::vector<std::byte>& values_;
  std::size_t size_;
  std::size_t components_;
};

/// Reads all components; `store(row, c, symbol)` takes the symbols.
template <class Store>
Result<void> read_components(ByteReader& in, std::uint32_t rows, std::size_t components, unsigned width,
                             Store store) {
  Symbols before;
  for (std::size_t c = 0; c < components; ++c) {
    DELTAMESH_TRY(Symbols symbols, read_symbols(in, rows, before, width));
    for (std::size_t i = 0; i < symbols.size(); ++i) store(i, c, symbols[i]);
    before = std::move(symbols);
  }
  return {};
}

Result<void> read_exact(ByteReader& in, Attribute& attribute, std::uint32_t rows) {
  const auto width = static_cast<unsigned>(8 * component_size(attribute.type));
  Values values(attribute, rows);
  return read_components(
      in, rows, attribute.components, width,
      [&](std::size_t i, std::size_t c, std::uint64_t symbol) { values.set(i, c, symbol); });
}

Result<void> read_normals(ByteReader& in, Attribute& attribute, std::uint32_t rows) {
  DELTAMESH_TRY(const int bits, read_bits(in, 2, 15));
  std::vector<OctahedralCode> codes(rows);
  DELTAMESH_CHECK(read_components(in, rows, 2, static_cast<unsigned>(bits),
                                  [&](std::size_t i, std::size_t c, std::uint64_t symbol) {
                                    codes[i][c] = static_cast<std::uint32_t>(symbol);
                                  }));
  const std::uint32_t zero = octahedral_zero(bits);
  Values values(attribute, rows);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    if ((codes[i][0] == zero) != (codes[i][1] == zero))
      return in.error(ErrorCode::kInvalidStream, "octahedral code outside its square", "ATTR-5");
    const auto normal = decode_octahedral(codes[i], bits);
    for (std::size_t c = 0; c < 3; ++c) values.set(i, c, normal[c]);
  }
  return {};
}

Result<void> read_colors(ByteReader& in, Attribute& attribute, std::uint32_t rows) {
  const int full_bits = max_color_bits(attribute.type);
  DELTAMESH_TRY(const int bits, read_bits(in, 1, full_bits));
  const std::uint32_t top = top_level(bits);
  const bool is_float = attribute.type == ComponentType::kF32;
  Values values(attribute, rows);
  return read_components(in, rows, attribute.components, static_cast<unsigned>(bits),
                         [&](std::size_t i, std::size_t c, std::uint64_t symbol) {
                           const auto level = static_cast<std::uint32_t>(symbol);
                           if (is_float) {
                             values.set(i, c, value_of(level, LevelRange{}, top));
                           } else {
                             values.set(i, c, std::uint64_t{rescale_level(level, top, top_level(full_bits))});
                           }
                         });
}

Result<void> read_uvs(ByteReader& in, Attribute& attribute, std::uint32_t rows) {
  DELTAMESH_TRY(const int bits, read_bits(in, 1, 24));
  std::array<LevelRange, 2> ranges;
  for (LevelRange& range : ranges) {
    DELTAMESH_TRY(range.min, in.read<float>());
    DELTAMESH_TRY(range.max, in.read<float>());
    if (!std::isfinite(range.min) || !std::isfinite(range.max) || range.min > range.max)
      return in.error(ErrorCode::kInvalidStream, "range of texture coordinates is not one", "ATTR-7");
  }
  Values values(attribute, rows);
  return read_components(
      in, rows, 2, static_cast<unsigned>(bits), [&](std::size_t i, std::size_t c, std::uint64_t symbol) {
        values.set(i, c, value_of(static_cast<std::uint32_t>(symbol), ranges[c], top_level(bits)));
      });
}

Result<void> read_coded(ByteReader& in, AttributeCoding coding, Attribute& attribute, std::uint32_t rows) {
  switch (coding) {
    case AttributeCoding::kExact:
      return read_exact(in, attribute, rows);
    case AttributeCoding::kOctahedral:
      return read_normals(in, attribute, rows);
    case AttributeCoding::kColorLevels:
      return read_colors(in, attribute, rows);
    case AttributeCoding::kUvLevels:
      return read_uvs(in, attribute, rows);
    default:
      return in.error(ErrorCode::kInvalidStream, "a compact attribute coding in a plain payload", "ATTR-2");
  }
}

}  // namespace

Result<void> read_plain_values(std::span<const std::byte> payload, Attribute& attribute, std::uint32_t rows) {
  ByteReader in(payload, kTagAttribute);
  DELTAMESH_TRY(const auto coding, in.read<std::uint8_t>());
  DELTAMESH_CHECK(read_coded(in, static_cast<AttributeCoding>(coding), attribute, rows));
  return in.finish();
}

}  // namespace deltamesh
