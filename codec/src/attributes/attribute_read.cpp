// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <array>
#include <cmath>

#include "attributes/attribute.h"
#include "attributes/attribute_payload.h"
#include "attributes/field_columns.h"
#include "attributes/levels.h"
#include "attributes/octahedral.h"
#include "attributes/symbols.h"
#include "base/byte_reader.h"
#include "base/checked.h"
#include "base/large_vector.h"
#include "format/tags.h"

namespace deltamesh {
namespace {

using Symbols = std::vector<std::uint64_t>;

Result<Attribute> read_header(ByteReader& in) {
  DELTAMESH_TRY(const auto kind, in.read<std::uint8_t>());
  DELTAMESH_TRY(const auto type, in.read<std::uint8_t>());
  DELTAMESH_TRY(const auto components, in.read<std::uint8_t>());
  DELTAMESH_TRY(const auto flags, in.read<std::uint8_t>());
  if (kind > static_cast<std::uint8_t>(AttributeKind::kGeneric))
    return in.error(ErrorCode::kInvalidStream, "unknown attribute kind", "ATTR-1");
  if (type > static_cast<std::uint8_t>(ComponentType::kF64))
    return in.error(ErrorCode::kInvalidStream, "unknown component type", "ATTR-1");
  if (components == 0 || components > kMaxComponents)
    return in.error(ErrorCode::kInvalidStream, "component count out of range", "ATTR-1");
  if (flags > 1) return in.error(ErrorCode::kInvalidStream, "reserved attribute flag set", "ATTR-1");
  DELTAMESH_TRY(const auto name_size, in.read<std::uint8_t>());
  DELTAMESH_TRY(const auto name, in.read_bytes(name_size));
  Attribute attribute;
  attribute.kind = static_cast<AttributeKind>(kind);
  attribute.type = static_cast<ComponentType>(type);
  attribute.components = components;
  attribute.normalized = flags == 1;
  for (const std::byte letter : name) attribute.name += static_cast<char>(letter);
  return attribute;
}

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

/// Where the symbols come from: the bytes after the fields, plain or, where there is a graph, compact.
struct SymbolSource {
  ByteReader& in;
  const Adjacency* graph;
  bool is_color = false;
};

/// Reads all components; `store(row, c, symbol)` takes the symbols.
template <class Store>
Result<void> read_components(const SymbolSource& source, std::uint32_t rows, std::size_t components,
                             unsigned width, Store store) {
  ByteReader& in = source.in;
  if (source.graph != nullptr) {
    DELTAMESH_TRY(const auto bytes, in.read_bytes(in.remaining()));
    DELTAMESH_TRY(
        const auto columns,
        read_field_columns(bytes, *source.graph,
                           {.components = components, .width = width, .is_color = source.is_color}));
    for (std::size_t c = 0; c < components; ++c)
      for (std::size_t i = 0; i < rows; ++i) store(i, c, columns[c][i]);
    return {};
  }
  Symbols before;
  for (std::size_t c = 0; c < components; ++c) {
    DELTAMESH_TRY(Symbols symbols, read_symbols(in, rows, before, width));
    for (std::size_t i = 0; i < symbols.size(); ++i) store(i, c, symbols[i]);
    before = std::move(symbols);
  }
  return {};
}

Result<void> read_exact(const SymbolSource& source, Attribute& attribute, std::uint32_t rows) {
  const auto width = static_cast<unsigned>(8 * component_size(attribute.type));
  Values values(attribute, rows);
  return read_components(
      source, rows, attribute.components, width,
      [&](std::size_t i, std::size_t c, std::uint64_t symbol) { values.set(i, c, symbol); });
}

Result<void> read_normals(const SymbolSource& source, Attribute& attribute, std::uint32_t rows) {
  DELTAMESH_TRY(const int bits, read_bits(source.in, 2, 15));
  std::vector<OctahedralCode> codes(rows);
  DELTAMESH_CHECK(read_components(source, rows, 2, static_cast<unsigned>(bits),
                                  [&](std::size_t i, std::size_t c, std::uint64_t symbol) {
                                    codes[i][c] = static_cast<std::uint32_t>(symbol);
                                  }));
  const std::uint32_t zero = octahedral_zero(bits);
  Values values(attribute, rows);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    if ((codes[i][0] == zero) != (codes[i][1] == zero))
      return source.in.error(ErrorCode::kInvalidStream, "octahedral code outside its square", "ATTR-5");
    const auto normal = decode_octahedral(codes[i], bits);
    for (std::size_t c = 0; c < 3; ++c) values.set(i, c, normal[c]);
  }
  return {};
}

Result<void> read_colors(const SymbolSource& source, Attribute& attribute, std::uint32_t rows) {
  const int full_bits = max_color_bits(attribute.type);
  DELTAMESH_TRY(const int bits, read_bits(source.in, 1, full_bits));
  const std::uint32_t top = top_level(bits);
  const bool is_float = attribute.type == ComponentType::kF32;
  Values values(attribute, rows);
  return read_components(source, rows, attribute.components, static_cast<unsigned>(bits),
                         [&](std::size_t i, std::size_t c, std::uint64_t symbol) {
                           const auto level = static_cast<std::uint32_t>(symbol);
                           if (is_float) {
                             values.set(i, c, value_of(level, LevelRange{}, top));
                           } else {
                             values.set(i, c, std::uint64_t{rescale_level(level, top, top_level(full_bits))});
                           }
                         });
}

Result<void> read_uvs(const SymbolSource& source, Attribute& attribute, std::uint32_t rows) {
  DELTAMESH_TRY(const int bits, read_bits(source.in, 1, 24));
  std::array<LevelRange, 2> ranges;
  for (LevelRange& range : ranges) {
    DELTAMESH_TRY(range.min, source.in.read<float>());
    DELTAMESH_TRY(range.max, source.in.read<float>());
    if (!std::isfinite(range.min) || !std::isfinite(range.max) || range.min > range.max)
      return source.in.error(ErrorCode::kInvalidStream, "range of texture coordinates is not one", "ATTR-7");
  }
  Values values(attribute, rows);
  return read_components(
      source, rows, 2, static_cast<unsigned>(bits), [&](std::size_t i, std::size_t c, std::uint64_t symbol) {
        values.set(i, c, value_of(static_cast<std::uint32_t>(symbol), ranges[c], top_level(bits)));
      });
}

Result<void> read_values(const SymbolSource& source, Attribute& attribute, std::uint32_t rows) {
  DELTAMESH_TRY(const auto byte, source.in.read<std::uint8_t>());
  const auto coding = static_cast<AttributeCoding>(byte);
  if (!coding_fits(coding, attribute.kind, attribute.type, attribute.components))
    return source.in.error(ErrorCode::kInvalidStream, "attribute coding that its shape does not allow",
                           "ATTR-2");
  switch (coding) {
    case AttributeCoding::kExact:
      return read_exact(source, attribute, rows);
    case AttributeCoding::kOctahedral:
      return read_normals(source, attribute, rows);
    case AttributeCoding::kColorLevels:
      return read_colors({.in = source.in, .graph = source.graph, .is_color = true}, attribute, rows);
    case AttributeCoding::kUvLevels:
      break;
  }
  return read_uvs(source, attribute, rows);
}

}  // namespace

Result<Attribute> read_attribute(Payload payload, std::uint32_t vertex_count, std::uint64_t max_bytes,
                                 const Adjacency* graph) {
  ByteReader in(payload.bytes, kTagAttribute);
  DELTAMESH_TRY(Attribute attribute, read_header(in));
  const std::size_t row = attribute.components * component_size(attribute.type);
  if (saturating_mul(vertex_count, row) > max_bytes)
    return in.error(ErrorCode::kLimitExceeded, "attribute values larger than allowed", "ATTR-8");
  const SymbolSource source{.in = in, .graph = payload.is_compact ? graph : nullptr};
  DELTAMESH_CHECK(read_values(source, attribute, vertex_count));
  DELTAMESH_CHECK(in.finish());
  return attribute;
}

}  // namespace deltamesh
