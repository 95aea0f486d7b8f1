// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The attributes that a descriptor names by their row of a table [ATTR-1].
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "format/chunk/attribute_descriptor.h"

namespace deltamesh {

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
inline constexpr std::array<UsualAttribute, 21> kUsual{{
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

inline constexpr std::uint8_t kSpelledOut = 0;
inline constexpr std::uint8_t kHasError = 1U << 7;
inline constexpr std::uint8_t kHasRms = 1U << 6;

}  // namespace deltamesh
