// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Descriptor of an attribute in a stream: type, name and achieved error [ATTR-1].
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "base/byte_reader.h"
#include "base/byte_writer.h"
#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

inline constexpr unsigned kMaxComponents = 16;
inline constexpr std::size_t kMaxAttributeName = 255;

// Bits of the flags.
inline constexpr std::uint8_t kFlagNormalized = 1;  ///< integers stand for [0, 1] or [-1, 1]
inline constexpr std::uint8_t kFlagLinear = 2;      ///< colours only: linear light

struct AttributeDescriptor {
  AttributeKind kind = AttributeKind::kGeneric;
  ComponentType type = ComponentType::kF32;
  std::uint8_t components = 1;
  std::uint8_t flags = 0;
  std::string name{};
  float error = 0;  ///< largest, in the unit of its kind, a short float, rounded up
  float rms = 0;    ///< at a mean error, likewise: of colours 255ths; else 0

  bool is_normalized() const noexcept { return (flags & kFlagNormalized) != 0; }
  bool is_linear() const noexcept { return (flags & kFlagLinear) != 0; }
  bool operator==(const AttributeDescriptor&) const = default;
};

/// Of an Attribute or what else has its members. Only colours can be linear.
template <class Shape>
AttributeDescriptor descriptor_of(const Shape& a) {
  const bool linear = a.linear && a.kind == AttributeKind::kColor;
  return {
      .kind = a.kind,
      .type = a.type,
      .components = a.components,
      .flags = static_cast<std::uint8_t>((a.normalized ? kFlagNormalized : 0) | (linear ? kFlagLinear : 0)),
      .name = std::string(a.name)};
}

/// Writes one byte for a usual attribute, and three more for each error that is not 0.
void write_descriptor(ByteWriter& out, const AttributeDescriptor& attribute);

/// Reads a descriptor. Errors: kTruncated, kInvalidStream [ATTR-1].
Result<AttributeDescriptor> read_descriptor(ByteReader& in);

}  // namespace deltamesh
