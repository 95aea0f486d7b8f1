// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/gltf/accessor.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "base/checked.h"
#include "base/try.h"
#include "io/components.h"

namespace deltamesh::gltf {
namespace {

struct ComponentNumber {
  int gltf;
  ComponentType type;
};
constexpr std::array<ComponentNumber, 6> kComponentNumbers{{{5120, ComponentType::kI8},
                                                            {5121, ComponentType::kU8},
                                                            {5122, ComponentType::kI16},
                                                            {5123, ComponentType::kU16},
                                                            {5125, ComponentType::kU32},
                                                            {5126, ComponentType::kF32}}};

struct TypeName {
  std::string_view name;
  std::uint8_t components;
  std::uint8_t columns;  ///< 1: no matrix
};
constexpr std::array<TypeName, 7> kTypeNames{{{"SCALAR", 1, 1},
                                              {"VEC2", 2, 1},
                                              {"VEC3", 3, 1},
                                              {"VEC4", 4, 1},
                                              {"MAT2", 4, 2},
                                              {"MAT3", 9, 3},
                                              {"MAT4", 16, 4}}};

std::optional<ComponentType> component_of_number(std::uint64_t number) noexcept {
  for (const ComponentNumber& entry : kComponentNumbers)
    if (static_cast<std::uint64_t>(entry.gltf) == number) return entry.type;
  return std::nullopt;
}

/// A view together with an offset into it, and rows that fit. Nothing: as view_bytes().
Result<std::optional<ViewBytes>> rows_in_view(const Document& document, const Json& place,
                                              std::size_t row_size, std::uint64_t count,
                                              std::size_t accessor) {
  const Error bad_view = accessor_error("the accessor's bufferView is malformed", accessor);
  const Error bad_offset = accessor_error("the accessor's byteOffset is malformed", accessor);
  const Error beyond = accessor_error("the accessor reaches beyond its buffer view", accessor);
  DELTAMESH_TRY(const auto view, unsigned_member(place, "bufferView", kNoLimit, kNoLimit - 1, bad_view));
  if (view == kNoLimit) return std::optional<ViewBytes>();
  DELTAMESH_TRY(const auto offset, unsigned_member(place, "byteOffset", 0, kNoLimit, bad_offset));
  DELTAMESH_TRY(const auto bytes, view_bytes(document, view));
  if (!bytes) return std::optional<ViewBytes>();
  const std::size_t stride = bytes->stride == 0 ? row_size : bytes->stride;
  if (stride < row_size)
    return accessor_error("the accessor's rows are longer than the view's byteStride", accessor);
  if (count == 0) return std::optional(ViewBytes{{}, stride});
  const auto last_row = saturating_mul(count - 1, stride);
  const auto end = saturating_add(saturating_add(offset, last_row), row_size);
  if (end > bytes->bytes.size()) return beyond;
  return std::optional(ViewBytes{bytes->bytes.subspan(static_cast<std::size_t>(offset)), stride});
}

std::vector<std::byte> copy_rows(const AccessorRows& rows) {
  std::vector<std::byte> dense;
  dense.reserve(static_cast<std::size_t>(rows.shape().count) * rows.shape().row_size());
  for (std::uint64_t i = 0; i < rows.shape().count; ++i) {
    const auto row = rows.row(i);
    dense.insert(dense.end(), row.begin(), row.end());
  }
  return dense;
}

/// Replaces the rows that `sparse` lists. False where its data is not plain.
Result<bool> apply_sparse(const Document& document, const Json& sparse, const AccessorShape& shape,
                          std::vector<std::byte>& dense, std::size_t accessor) {
  const Error bad = accessor_error("the accessor's sparse part is malformed", accessor);
  const Json* indices = find(sparse, "indices");
  const Json* values = find(sparse, "values");
  if (!indices || !values) return bad;
  DELTAMESH_TRY(const auto count, unsigned_member(sparse, "count", 0, shape.count, bad));
  DELTAMESH_TRY(const auto number, unsigned_member(*indices, "componentType", 0, kNoLimit, bad));
  const auto type = component_of_number(number);
  if (!type || !is_index_shape({.type = *type})) return bad;

  const std::size_t index_size = component_size(*type);
  const std::size_t row_size = shape.row_size();
  DELTAMESH_TRY(const auto index_view, rows_in_view(document, *indices, index_size, count, accessor));
  DELTAMESH_TRY(const auto value_view, rows_in_view(document, *values, row_size, count, accessor));
  if (!index_view || !value_view) return false;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t target = read_index(index_view->bytes.subspan(i * index_view->stride, index_size));
    if (target >= shape.count) return accessor_error("a sparse index beyond the accessor's count", accessor);
    const auto row = value_view->bytes.subspan(i * value_view->stride, row_size);
    std::copy(row.begin(), row.end(), dense.begin() + static_cast<std::ptrdiff_t>(target * row_size));
  }
  return true;
}

}  // namespace

int gltf_component_type(ComponentType type) noexcept {
  for (const ComponentNumber& entry : kComponentNumbers)
    if (entry.type == type) return entry.gltf;
  return 0;
}

Result<std::optional<AccessorShape>> accessor_shape(const Document& document, std::size_t accessor) {
  const Json& json = document.json["accessors"][accessor];
  const Error bad =
      accessor_error("the accessor's type, componentType or count is missing or malformed", accessor);
  const Json* type_name = find(json, "type");
  if (!type_name || !type_name->is_string() || !json.contains("count")) return bad;
  DELTAMESH_TRY(const auto number, unsigned_member(json, "componentType", 0, kNoLimit, bad));
  DELTAMESH_TRY(const auto count, unsigned_member(json, "count", 0, kNoLimit, bad));
  const auto type = component_of_number(number);
  const auto& name = type_name->get_ref<const std::string&>();
  const auto found = std::find_if(kTypeNames.begin(), kTypeNames.end(),
                                  [&](const TypeName& known) { return known.name == name; });
  if (!type || found == kTypeNames.end()) return std::optional<AccessorShape>();
  // Columns of matrices start at multiples of four bytes.
  const bool is_matrix = found->columns > 1;
  if (is_matrix && found->components / found->columns * component_size(*type) % 4 != 0)
    return std::optional<AccessorShape>();
  const Json* normalized = find(json, "normalized");
  return std::optional(AccessorShape{.type = *type,
                                     .components = found->components,
                                     .normalized = normalized && *normalized == true,
                                     .is_matrix = is_matrix,
                                     .count = count});
}

Result<std::uint64_t> stored_bytes(const Document& document, std::size_t accessor) {
  DELTAMESH_TRY(const auto shape, accessor_shape(document, accessor));
  if (!shape) return std::uint64_t{0};
  const Json& json = document.json["accessors"][accessor];
  std::uint64_t bytes = json.contains("bufferView") ? saturating_mul(shape->count, shape->row_size()) : 0;
  if (const Json* sparse = find(json, "sparse")) {
    constexpr std::uint64_t kIndexBytes = 4;
    const Error bad = accessor_error("the accessor's sparse part is malformed", accessor);
    DELTAMESH_TRY(const auto count, unsigned_member(*sparse, "count", 0, kNoLimit, bad));
    bytes = saturating_add(bytes, saturating_mul(count, kIndexBytes + shape->row_size()));
  }
  return bytes;
}

Result<std::optional<ViewBytes>> view_bytes(const Document& document, std::uint64_t view) {
  if (view >= array_size(document.json, "bufferViews"))
    return element_error("a reference to a buffer view that does not exist", view);
  const Json& json = document.json["bufferViews"][static_cast<std::size_t>(view)];
  const Error bad = element_error("the buffer view is malformed", view);
  DELTAMESH_TRY(const auto buffer_number, unsigned_member(json, "buffer", kNoLimit, kNoLimit, bad));
  DELTAMESH_TRY(const auto offset, unsigned_member(json, "byteOffset", 0, kNoLimit, bad));
  DELTAMESH_TRY(const auto length, unsigned_member(json, "byteLength", 0, kNoLimit, bad));
  DELTAMESH_TRY(const auto stride, unsigned_member(json, "byteStride", 0, kNoLimit, bad));
  if (buffer_number >= document.buffers.size())
    return element_error("the buffer view's buffer does not exist", view);
  const Buffer& buffer = document.buffers[static_cast<std::size_t>(buffer_number)];
  if (buffer.opaque) return std::optional<ViewBytes>();
  if (saturating_add(offset, length) > buffer.bytes.size())
    return element_error("the buffer view reaches beyond its buffer", view);
  return std::optional(
      ViewBytes{buffer.bytes.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(length)),
                static_cast<std::size_t>(stride)});
}

Result<std::optional<AccessorRows>> read_accessor(const Document& document, std::size_t accessor,
                                                  std::uint64_t zero_rows) {
  DELTAMESH_TRY(const auto shape, accessor_shape(document, accessor));
  if (!shape) return std::optional<AccessorRows>();
  const Json& json = document.json["accessors"][accessor];
  const std::size_t row_size = shape->row_size();
  std::optional<AccessorRows> rows;
  if (json.contains("bufferView")) {
    DELTAMESH_TRY(const auto view, rows_in_view(document, json, row_size, shape->count, accessor));
    if (view) rows.emplace(*shape, view->bytes, view->stride);
  } else if (shape->count <= zero_rows) {
    rows.emplace(*shape, std::vector<std::byte>(row_size), std::size_t{0});
  }
  const Json* sparse = find(json, "sparse");
  if (!rows || !sparse) return rows;
  auto dense = copy_rows(*rows);
  DELTAMESH_TRY(const bool plain, apply_sparse(document, *sparse, *shape, dense, accessor));
  if (!plain) return std::optional<AccessorRows>();
  return std::optional(AccessorRows(*shape, std::move(dense), row_size));
}

Vec3 vector_at(const AccessorRows& rows, std::uint64_t i) noexcept {
  const AccessorShape& shape = rows.shape();
  Vec3 vector{};
  for (std::size_t k = 0; k < 3; ++k)
    vector[k] =
        load_normalized(shape.type, shape.normalized, rows.row(i).data() + k * component_size(shape.type));
  return vector;
}

bool is_index_shape(const AccessorShape& shape) noexcept {
  return shape.components == 1 && (shape.type == ComponentType::kU8 || shape.type == ComponentType::kU16 ||
                                   shape.type == ComponentType::kU32);
}

std::uint32_t read_index(std::span<const std::byte> row) noexcept {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < row.size() && i < 4; ++i)
    value |= std::to_integer<std::uint32_t>(row[i]) << (8 * i);
  return value;
}

}  // namespace deltamesh::gltf
