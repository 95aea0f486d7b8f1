// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "document/semantics.h"

#include <cstdint>
#include <cstring>
#include <limits>

namespace deltamesh::gltf {
namespace {

bool is_float(const AccessorShape& shape) noexcept { return shape.type == ComponentType::kF32; }

bool is_small_unsigned(const AccessorShape& shape) noexcept {
  return shape.type == ComponentType::kU8 || shape.type == ComponentType::kU16;
}

/// Writes "all", the full value of a component: 1, or the largest integer.
void write_full(std::vector<std::byte>& row, std::size_t component, ComponentType type) noexcept {
  constexpr float kOne = 1;
  constexpr std::uint16_t kLargest = std::numeric_limits<std::uint16_t>::max();
  const std::size_t size = component_size(type);
  if (type == ComponentType::kF32)
    std::memcpy(row.data() + component * size, &kOne, size);
  else if (type == ComponentType::kU8 || type == ComponentType::kU16)
    std::memcpy(row.data() + component * size, &kLargest, size);
}

}  // namespace

AttributeKind kind_of(const Semantic& semantic, const AccessorShape& shape) noexcept {
  if (semantic.target != kBase || shape.is_matrix) return AttributeKind::kGeneric;
  const std::string_view name = semantic.name;
  const bool floats = is_float(shape);
  const bool levels = floats || (shape.normalized && is_small_unsigned(shape));
  if (name == "NORMAL" && floats && shape.components == 3) return AttributeKind::kNormal;
  if (name == "TANGENT" && floats && shape.components == 4) return AttributeKind::kTangent;
  if (name.starts_with("TEXCOORD_") && floats && shape.components == 2) return AttributeKind::kUv;
  if (name.starts_with("COLOR_") && levels && shape.components >= 3) return AttributeKind::kColor;
  if (name.starts_with("JOINTS_") && is_small_unsigned(shape)) return AttributeKind::kJoints;
  if (name.starts_with("WEIGHTS_") && levels) return AttributeKind::kWeights;
  return AttributeKind::kGeneric;
}

bool is_look(const Semantic& semantic) noexcept {
  const std::string_view name = semantic.name;
  return semantic.target == kBase && (name == "NORMAL" || name == "TANGENT" ||
                                      name.starts_with("TEXCOORD_") || name.starts_with("COLOR_"));
}

std::string stream_name(const Semantic& semantic, const AccessorShape& shape) {
  constexpr std::size_t kMaxNameBytes = 254;
  if (kind_of(semantic, shape) != AttributeKind::kGeneric || semantic.name.size() > kMaxNameBytes) return {};
  if (semantic.target == kBase) return semantic.name;
  return is_float(shape) ? "d" + semantic.name : std::string();
}

std::vector<std::byte> filler_row(AttributeKind kind, const AccessorShape& shape) {
  std::vector<std::byte> row(shape.row_size());
  if (kind == AttributeKind::kColor)
    for (std::size_t k = 0; k < shape.components; ++k) write_full(row, k, shape.type);
  if (kind == AttributeKind::kWeights || kind == AttributeKind::kTangent) write_full(row, 0, shape.type);
  if (kind == AttributeKind::kNormal) write_full(row, 2, shape.type);
  if (kind == AttributeKind::kTangent) write_full(row, 3, shape.type);
  return row;
}

bool is_core_shape(const Semantic& semantic, const AccessorShape& shape) noexcept {
  const std::string_view name = semantic.name;
  if (name == "POSITION" || name == "NORMAL" || name == "TANGENT") return is_float(shape);
  if (name.starts_with("TEXCOORD_") && semantic.target == kBase)
    return is_float(shape) || (shape.normalized && is_small_unsigned(shape));
  return true;
}

bool is_position_shape(const AccessorShape& shape) noexcept {
  return shape.components == 3 && shape.type != ComponentType::kU32 && !shape.is_matrix;
}

}  // namespace deltamesh::gltf
