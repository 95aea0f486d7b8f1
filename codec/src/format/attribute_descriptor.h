// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a stream says of an attribute: its shape, its name and its achieved error [ATTR-1].
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

/// One byte for an attribute that is one of the usual ones, and three more for an error other than 0.
void write_descriptor(ByteWriter& out, const AttributeDescriptor& attribute);

/// Errors: kTruncated, kInvalidStream [ATTR-1].
Result<AttributeDescriptor> read_descriptor(ByteReader& in);

}  // namespace deltamesh
