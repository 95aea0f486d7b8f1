// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <span>

#include "format/chunk/attribute_descriptor.h"
#include "format/chunk/usual_attributes.h"

namespace deltamesh {
namespace {

/// The row of an attribute's shape and name.
std::uint8_t row_of(const AttributeDescriptor& attribute) noexcept {
  const auto* const found = std::find_if(kUsual.begin(), kUsual.end(),
                                         [&](const UsualAttribute& usual) { return usual.is(attribute); });
  return found == kUsual.end() ? kSpelledOut : static_cast<std::uint8_t>(found - kUsual.begin() + 1);
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

}  // namespace deltamesh
