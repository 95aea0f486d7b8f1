// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <array>
#include <cmath>

#include "attributes/attribute.h"
#include "attributes/attribute_payload.h"
#include "attributes/field_columns.h"
#include "attributes/levels.h"
#include "attributes/octahedral.h"
#include "attributes/symbols.h"
#include "base/byte_writer.h"
#include "base/vec3.h"

namespace deltamesh {
namespace {

/// Normals of a length this far from 1 are data, not directions: they are stored exactly.
constexpr double kUnitTolerance = 1e-2;

/// The attribute's values, by coded vertex.
class Rows {
 public:
  Rows(const AttributeView& attribute, std::span<const std::uint32_t> order)
      : values_(attribute.values),
        order_(order),
        size_(component_size(attribute.type)),
        components_(attribute.components) {}

  std::size_t count() const noexcept { return order_.size(); }
  std::uint64_t bits(std::size_t row, std::size_t component) const noexcept {
    return load_component(values_.data() + (order_[row] * components_ + component) * size_, size_);
  }
  float number(std::size_t row, std::size_t component) const noexcept {
    return std::bit_cast<float>(static_cast<std::uint32_t>(bits(row, component)));
  }
  Vec3 vector(std::size_t row) const noexcept {
    return {static_cast<double>(number(row, 0)), static_cast<double>(number(row, 1)),
            static_cast<double>(number(row, 2))};
  }

 private:
  std::span<const std::byte> values_;
  std::span<const std::uint32_t> order_;
  std::size_t size_;
  std::size_t components_;
};

Error sizes_disagree(const char* message) { return {.code = ErrorCode::kInvalidMesh, .message = message}; }

Result<void> check_shape(const AttributeView& attribute, std::span<const std::uint32_t> order) {
  if (attribute.components == 0 || attribute.components > kMaxComponents)
    return sizes_disagree("an attribute has no component or too many");
  if (attribute.name.size() > kMaxAttributeName) return sizes_disagree("an attribute's name is too long");
  const std::size_t row = attribute.components * component_size(attribute.type);
  if (attribute.values.size() % row != 0)
    return sizes_disagree("an attribute's values are not whole vertices");
  const std::size_t rows = attribute.values.size() / row;
  if (std::any_of(order.begin(), order.end(), [rows](std::uint32_t vertex) { return vertex >= rows; }))
    return sizes_disagree("an attribute has fewer values than the mesh has vertices");
  return {};
}

bool all_unit_or_zero(const Rows& rows) {
  for (std::size_t i = 0; i < rows.count(); ++i) {
    const double size = length(rows.vector(i));
    if (size != 0 && !(std::fabs(size - 1) <= kUnitTolerance)) return false;
  }
  return true;
}

/// Smallest and largest value of a component. False where one is not finite.
bool find_range(const Rows& rows, std::size_t component, LevelRange& range) {
  if (rows.count() != 0) range = {rows.number(0, component), rows.number(0, component)};
  for (std::size_t i = 0; i < rows.count(); ++i) {
    const float value = rows.number(i, component);
    if (!std::isfinite(value)) return false;
    range.min = std::min(range.min, value);
    range.max = std::max(range.max, value);
  }
  return true;
}

bool all_in_unit_range(const Rows& rows, std::size_t components) {
  LevelRange range;
  for (std::size_t c = 0; c < components; ++c)
    if (!find_range(rows, c, range) || range.min < 0 || range.max > 1) return false;
  return true;
}

using Symbols = std::vector<std::uint64_t>;

template <class SymbolOfRow>
Symbols symbols_of(const Rows& rows, SymbolOfRow symbol_of_row) {
  Symbols symbols;
  symbols.reserve(rows.count());
  for (std::size_t i = 0; i < rows.count(); ++i) symbols.push_back(symbol_of_row(i));
  return symbols;
}

/// Where the symbols go: the bytes after the fields, plain or, where there is a graph, compact.
struct SymbolSink {
  ByteWriter& out;
  const Adjacency* graph;
  bool is_color = false;
  bool has_form = true;  ///< false once the attribute turned out to have no compact form
};

/// Writes all components; `make(c)` gives the symbols of component c.
template <class MakeComponent>
void write_components(SymbolSink& sink, std::size_t components, unsigned width, MakeComponent make) {
  if (sink.graph == nullptr) {
    Symbols before;
    for (std::size_t c = 0; c < components; ++c) {
      Symbols symbols = make(c);
      write_symbols(sink.out, symbols, before, width);
      before = std::move(symbols);
    }
    return;
  }
  sink.has_form = width <= kWidestField;
  if (!sink.has_form) return;
  FieldColumns columns;
  for (std::size_t c = 0; c < components; ++c) columns.push_back(make(c));
  sink.out.write_bytes(write_field_columns(
      columns, *sink.graph, {.components = components, .width = width, .is_color = sink.is_color}));
}

void write_coding(ByteWriter& out, AttributeCoding coding) { out.write(static_cast<std::uint8_t>(coding)); }

void write_exact(SymbolSink& sink, const AttributeView& attribute, const Rows& rows) {
  write_coding(sink.out, AttributeCoding::kExact);
  const auto width = static_cast<unsigned>(8 * component_size(attribute.type));
  write_components(sink, attribute.components, width, [&](std::size_t c) {
    return symbols_of(rows, [&](std::size_t i) { return rows.bits(i, c); });
  });
}

void write_normals(SymbolSink& sink, const Rows& rows, int bits) {
  write_coding(sink.out, AttributeCoding::kOctahedral);
  sink.out.write(static_cast<std::uint8_t>(bits));
  std::array<Symbols, 2> codes;
  for (std::size_t i = 0; i < rows.count(); ++i) {
    const OctahedralCode code = encode_octahedral(rows.vector(i), bits);
    codes[0].push_back(code[0]);
    codes[1].push_back(code[1]);
  }
  write_components(sink, 2, static_cast<unsigned>(bits), [&](std::size_t c) { return std::move(codes[c]); });
}

void write_colors(SymbolSink& sink, const AttributeView& attribute, const Rows& rows, int asked_bits) {
  const int bits = std::min(asked_bits, max_color_bits(attribute.type));
  write_coding(sink.out, AttributeCoding::kColorLevels);
  sink.out.write(static_cast<std::uint8_t>(bits));
  const std::uint32_t top = top_level(bits);
  const std::uint32_t full = top_level(max_color_bits(attribute.type));
  const bool is_float = attribute.type == ComponentType::kF32;
  sink.is_color = true;
  write_components(sink, attribute.components, static_cast<unsigned>(bits), [&](std::size_t c) {
    return symbols_of(rows, [&](std::size_t i) {
      return is_float ? level_of(rows.number(i, c), LevelRange{}, top)
                      : rescale_level(static_cast<std::uint32_t>(rows.bits(i, c)), full, top);
    });
  });
}

void write_uvs(SymbolSink& sink, const Rows& rows, const std::array<LevelRange, 2>& ranges, int bits) {
  write_coding(sink.out, AttributeCoding::kUvLevels);
  sink.out.write(static_cast<std::uint8_t>(bits));
  for (const LevelRange& range : ranges) {
    sink.out.write(range.min);
    sink.out.write(range.max);
  }
  write_components(sink, 2, static_cast<unsigned>(bits), [&](std::size_t c) {
    return symbols_of(rows,
                      [&](std::size_t i) { return level_of(rows.number(i, c), ranges[c], top_level(bits)); });
  });
}

void write_values(SymbolSink& sink, const AttributeView& attribute, const Rows& rows,
                  const AttributeQuantization& quantization) {
  const auto fits = [&](AttributeCoding coding) {
    return coding_fits(coding, attribute.kind, attribute.type, attribute.components);
  };
  if (quantization.exact) return write_exact(sink, attribute, rows);
  if (fits(AttributeCoding::kOctahedral) && all_unit_or_zero(rows))
    return write_normals(sink, rows, quantization.normal_bits);
  if (fits(AttributeCoding::kColorLevels) &&
      (attribute.type != ComponentType::kF32 || all_in_unit_range(rows, attribute.components)))
    return write_colors(sink, attribute, rows, quantization.color_bits);
  std::array<LevelRange, 2> ranges;
  if (fits(AttributeCoding::kUvLevels) && find_range(rows, 0, ranges[0]) && find_range(rows, 1, ranges[1]))
    return write_uvs(sink, rows, ranges, quantization.uv_bits);
  write_exact(sink, attribute, rows);
}

/// Fields, then values; empty where `graph` is given and the attribute has no compact form.
Result<std::vector<std::byte>> write_form(const AttributeView& attribute,
                                          std::span<const std::uint32_t> order,
                                          const AttributeQuantization& quantization, const Adjacency* graph) {
  DELTAMESH_CHECK(check_shape(attribute, order));
  ByteWriter out;
  out.write(static_cast<std::uint8_t>(attribute.kind));
  out.write(static_cast<std::uint8_t>(attribute.type));
  out.write(attribute.components);
  out.write(static_cast<std::uint8_t>(attribute.normalized ? 1 : 0));
  out.write(static_cast<std::uint8_t>(attribute.name.size()));
  out.write_bytes(std::as_bytes(std::span(attribute.name)));
  SymbolSink sink{.out = out, .graph = graph};
  write_values(sink, attribute, Rows(attribute, order), quantization);
  return sink.has_form ? out.take() : std::vector<std::byte>{};
}

}  // namespace

Result<std::vector<std::byte>> write_attribute(const AttributeView& attribute,
                                               std::span<const std::uint32_t> order,
                                               const AttributeQuantization& quantization) {
  return write_form(attribute, order, quantization, nullptr);
}

Result<std::vector<std::byte>> write_compact_attribute(const AttributeView& attribute,
                                                       std::span<const std::uint32_t> order,
                                                       const AttributeQuantization& quantization,
                                                       const Adjacency& graph) {
  return write_form(attribute, order, quantization, &graph);
}

}  // namespace deltamesh
