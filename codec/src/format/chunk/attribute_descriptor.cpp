// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "format/chunk/attribute_descriptor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

namespace deltamesh {
namespace {

/// An attribute with a name and a type that glTF files and this library's readers use.
struct UsualAttribute {
  std::string_view name;
  AttributeKind kind;
  ComponentType type;
  std::uint8_t components;
  std::uint8_t flags = 0;

  bool is(const AttributeDescriptor& a) const noexcept {
    return a.name == name && a.kind == kind && a.type == type && a.components == components &&
           a.flags == flags;
  }
};

/// In the order of the table of [ATTR-1], from row 1 on.
constexpr std::array<UsualAttribute, 21> kUsual{{
    {"NORMAL", AttributeKind::kNormal, ComponentType::kF32, 3},
    {"TANGENT", AttributeKind::kTangent, ComponentType::kF32, 4},
    {"TEXCOORD_0", AttributeKind::kUv, ComponentType::kF32, 2},
    {"TEXCOORD_1", AttributeKind::kUv, ComponentType::kF32, 2},
    {"COLOR_0", AttributeKind::kColor, ComponentType::kU8, 4, 3},
    {"COLOR_0", AttributeKind::kColor, ComponentType::kU8, 3, 3},
    {"COLOR_0", AttributeKind::kColor, ComponentType::kU16, 4, 3},
    {"COLOR_0", AttributeKind::kColor, ComponentType::kU16, 3, 3},
    {"COLOR_0", AttributeKind::kColor, ComponentType::kF32, 4, 2},
    {"COLOR_0", AttributeKind::kColor, ComponentType::kF32, 3, 2},
    {"JOINTS_0", AttributeKind::kJoints, ComponentType::kU8, 4},
    {"JOINTS_0", AttributeKind::kJoints, ComponentType::kU16, 4},
    {"WEIGHTS_0", AttributeKind::kWeights, ComponentType::kF32, 4},
    {"WEIGHTS_0", AttributeKind::kWeights, ComponentType::kU8, 4, 1},
    {"WEIGHTS_0", AttributeKind::kWeights, ComponentType::kU16, 4, 1},
    {"nx", AttributeKind::kNormal, ComponentType::kF32, 3},
    {"red", AttributeKind::kColor, ComponentType::kU8, 3, 1},
    {"red", AttributeKind::kColor, ComponentType::kU8, 4, 1},
    {"s", AttributeKind::kUv, ComponentType::kF32, 2},
    {"vn", AttributeKind::kNormal, ComponentType::kF32, 3},
    {"vt", AttributeKind::kUv, ComponentType::kF32, 2},
}};

constexpr std::uint8_t kSpelledOut = 0;
constexpr std::uint8_t kHasError = 1U << 7;
constexpr std::uint8_t kHasRms = 1U << 6;

/// The row of an attribute's shape and name.
std::uint8_t row_of(const AttributeDescriptor& attribute) noexcept {
  const auto* const found = std::find_if(kUsual.begin(), kUsual.end(),
                                         [&](const UsualAttribute& usual) { return usual.is(attribute); });
  return found == kUsual.end() ? kSpelledOut : static_cast<std::uint8_t>(found - kUsual.begin() + 1);
}

Result<AttributeDescriptor> read_spelled_out(ByteReader& in) {
  const auto invalid = [&in](const char* message) { return in.invalid(message, "ATTR-1"); };
  AttributeDescriptor a;
  DELTAMESH_TRY(const auto kind, in.read<std::uint8_t>());
  DELTAMESH_TRY(const auto type, in.read<std::uint8_t>());
  DELTAMESH_TRY(a.components, in.read<std::uint8_t>());
  DELTAMESH_TRY(a.flags, in.read<std::uint8_t>());
  if (kind >= kAttributeKinds) return invalid("unknown attribute kind");
  if (type > static_cast<std::uint8_t>(ComponentType::kF64)) return invalid("unknown component type");
  if (a.components == 0 || a.components > kMaxComponents) return invalid("component count out of range");
  a.kind = static_cast<AttributeKind>(kind);
  const unsigned flags = a.kind == AttributeKind::kColor ? kFlagNormalized | kFlagLinear : kFlagNormalized;
  if (a.flags > flags) return invalid("reserved attribute flag set");
  a.type = static_cast<ComponentType>(type);
  DELTAMESH_TRY(const auto size, in.read<std::uint8_t>());
  DELTAMESH_TRY(const auto letters, in.read_bytes(size));
  a.name = std::string(reinterpret_cast<const char*>(letters.data()), letters.size());
  return a;
}

}  // namespace

void write_descriptor(ByteWriter& out, const AttributeDescriptor& attribute) {
  const std::uint8_t row = row_of(attribute);
  const bool has_error = attribute.error != 0;
  const bool has_rms = attribute.rms != 0;
  out.write(static_cast<std::uint8_t>(row | (has_error ? kHasError : 0) | (has_rms ? kHasRms : 0)));
  if (row == kSpelledOut) {
    out.write(static_cast<std::uint8_t>(attribute.kind));
    out.write(static_cast<std::uint8_t>(attribute.type));
    out.write(attribute.components);
    out.write(attribute.flags);
    out.write(static_cast<std::uint8_t>(attribute.name.size()));
    out.write_bytes(std::as_bytes(std::span(attribute.name)));
  }
  if (has_error) out.write_short_float(attribute.error);
  if (has_rms) out.write_short_float(attribute.rms);
}

Result<AttributeDescriptor> read_descriptor(ByteReader& in) {
  DELTAMESH_TRY(const auto first, in.read<std::uint8_t>());
  const unsigned row = first & ~(kHasError | kHasRms);
  if (row > kUsual.size()) return in.invalid("no such row of usual attributes", "ATTR-1");
  AttributeDescriptor attribute;
  if (row == kSpelledOut) {
    DELTAMESH_TRY(attribute, read_spelled_out(in));
  } else {
    const UsualAttribute& usual = kUsual[row - 1];
    attribute = {usual.kind, usual.type, usual.components, usual.flags, std::string(usual.name)};
  }
  const auto read_error = [&](unsigned flag, float& error) -> Result<void> {
    if ((first & flag) == 0) return {};
    DELTAMESH_TRY(error, in.read_short_float());
    if (!std::isfinite(error) || error < 0)
      return in.invalid("an attribute's error is not a number of at least 0", "ATTR-1");
    return {};
  };
  DELTAMESH_CHECK(read_error(kHasError, attribute.error));
  DELTAMESH_CHECK(read_error(kHasRms, attribute.rms));
  return attribute;
}

}  // namespace deltamesh
