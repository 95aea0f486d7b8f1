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

struct AttributeDescriptor {
  AttributeKind kind = AttributeKind::kGeneric;
  ComponentType type = ComponentType::kF32;
  std::uint8_t components = 1;
  std::uint8_t flags = 0;  ///< bit 0: normalised integers
  std::string name{};
  float error = 0;  ///< largest, in the unit of its kind, a short float, rounded up

  bool operator==(const AttributeDescriptor&) const = default;
};

/// Writes one byte for a usual attribute (usual_attributes.h), and three more if the error is not 0.
void write_descriptor(ByteWriter& out, const AttributeDescriptor& attribute);

/// Reads a descriptor. Errors: kTruncated, kInvalidStream [ATTR-1].
Result<AttributeDescriptor> read_descriptor(ByteReader& in);

}  // namespace deltamesh
