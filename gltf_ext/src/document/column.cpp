// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "document/column.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "base/component.h"

namespace deltamesh::gltf {
namespace {

static_assert(std::endian::native == std::endian::little,
              "glTF data is little-endian, and so are our arrays");

constexpr const char* kIndexTypeName = "SCALAR";
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;

/// Smallest and largest of one component over all rows; nothing is written where one of them is not finite.
void add_bounds(Json& low, Json& high, const Column& column, std::size_t component) {
  with_component(column.shape.type, [&](auto value) {
    auto smallest = std::numeric_limits<decltype(value)>::max();
    auto largest = std::numeric_limits<decltype(value)>::lowest();
    for (std::size_t i = 0; i < column.shape.count; ++i) {
      std::memcpy(&value, column.rows.data() + i * column.shape.row_size() + component * sizeof value,
                  sizeof value);
      if constexpr (std::is_floating_point_v<decltype(value)>) {
        if (!std::isfinite(value)) return;
      }
      smallest = std::min(smallest, value);
      largest = std::max(largest, value);
    }
    low.push_back(smallest);
    high.push_back(largest);
  });
}

}  // namespace

Column position_column(const Mesh& mesh) noexcept {
  return {.shape = {.type = ComponentType::kF32, .components = 3, .count = mesh.vertex_count()},
          .rows = std::as_bytes(std::span(mesh.positions)),
          .is_indices = false};
}

Column attribute_column(const Mesh& mesh, const Attribute& attribute) noexcept {
  return {.shape = {.type = attribute.type,
                    .components = attribute.components,
                    .normalized = attribute.normalized,
                    .count = mesh.vertex_count()},
          .rows = attribute.values,
          .is_indices = false};
}

Column index_column(ComponentType type, std::span<const std::byte> bytes) noexcept {
  return {.shape = {.type = type, .components = 1, .count = bytes.size() / component_size(type)},
          .rows = bytes,
          .is_indices = true};
}

ComponentType index_type(std::span<const std::uint32_t> corners) noexcept {
  const std::uint32_t largest = corners.empty() ? 0 : *std::max_element(corners.begin(), corners.end());
  return largest < std::numeric_limits<std::uint16_t>::max() ? ComponentType::kU16 : ComponentType::kU32;
}

std::vector<std::byte> index_bytes(std::span<const std::uint32_t> corners, ComponentType type) {
  const std::size_t size = component_size(type);
  std::vector<std::byte> bytes(corners.size() * size);
  for (std::size_t i = 0; i < corners.size(); ++i)
    std::memcpy(bytes.data() + i * size, &corners[i], size);  // little-endian: the low bytes come first
  return bytes;
}

std::vector<std::vector<std::uint32_t>> corners_by_group(const Mesh& mesh) {
  if (mesh.face_groups.empty()) return {mesh.triangles};
  std::vector<std::vector<std::uint32_t>> groups;
  for (std::size_t face = 0; face < mesh.triangle_count(); ++face) {
    const std::size_t group = mesh.face_groups[face];
    if (group >= groups.size()) groups.resize(group + 1);
    const auto first = mesh.triangles.begin() + static_cast<std::ptrdiff_t>(3 * face);
    groups[group].insert(groups[group].end(), first, first + 3);
  }
  return groups;
}

void describe_column(Json& accessor, const Column& column, bool bounds) {
  const bool had_bounds = accessor.contains("min") || accessor.contains("max");
  for (const char* key : {"bufferView", "byteOffset", "sparse"}) accessor.erase(key);
  accessor["componentType"] = gltf_component_type(column.shape.type);
  accessor["count"] = column.shape.count;
  if (column.shape.type == ComponentType::kF32) accessor.erase("normalized");
  if (!accessor.contains("type")) accessor["type"] = kIndexTypeName;
  if (!bounds && !had_bounds) return;
  Json low = Json::array();
  Json high = Json::array();
  for (std::size_t k = 0; k < column.shape.components; ++k) add_bounds(low, high, column, k);
  if (low.size() == column.shape.components) {
    accessor["min"] = std::move(low);
    accessor["max"] = std::move(high);
  } else {
    accessor.erase("min");
    accessor.erase("max");
  }
}

std::size_t append_column(Document& document, const Column& column) {
  const std::size_t row_size = column.shape.row_size();
  const std::size_t stride = column.is_indices ? row_size : (row_size + 3) / 4 * 4;
  std::vector<std::byte> bytes(static_cast<std::size_t>(column.shape.count) * stride);
  for (std::size_t i = 0; i < column.shape.count; ++i)
    std::memcpy(bytes.data() + i * stride, column.rows.data() + i * row_size, row_size);
  const std::size_t view = append_view(document, std::move(bytes));
  Json& json = document.json["bufferViews"][view];
  if (!column.is_indices) json["byteStride"] = stride;
  json["target"] = column.is_indices ? kElementArrayBuffer : kArrayBuffer;
  return view;
}

}  // namespace deltamesh::gltf
