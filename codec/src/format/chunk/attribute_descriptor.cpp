// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "format/chunk/attribute_descriptor.h"

#include <cmath>
#include <string>

#include "format/chunk/usual_attributes.h"

namespace deltamesh {
namespace {

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
