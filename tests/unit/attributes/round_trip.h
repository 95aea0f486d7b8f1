// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Attributes through writer and reader.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "attributes/attribute.h"
#include "attributes/payload.h"
#include "support/attribute_coding.h"

namespace deltamesh::test {

/// Writes and reads back; a reader gets what the writer said.
inline CodedAttribute code(const Attribute& a, const AttributeQuality& quality,
                           const AttributeSurface& surface, std::span<const Attribute> others = {}) {
  auto coded = write_attribute(view(a), identity(rows(a)), {.quality = quality}, surface, others);
  EXPECT_TRUE(coded);
  const Payload payload = coded->is_compact ? Payload::compact(coded->payload) : Payload(coded->payload);
  const auto back = read_attribute(payload, coded->descriptor, surface, others, 1 << 24);
  EXPECT_TRUE(back) << (back ? "" : describe(back.error()));
  if (back) {
    EXPECT_EQ(back->values, coded->decoded.values);
  }
  return *std::move(coded);
}

/// The rule that a compact payload of so many vertices breaks, or "none".
inline const char* broken_rule(const std::vector<std::byte>& payload, const AttributeDescriptor& descriptor,
                               std::uint32_t vertices) {
  const auto read =
      read_attribute(Payload::compact(payload), descriptor, AttributeSurface({}, vertices), {}, 1 << 20);
  return read ? "none" : read.error().rule;
}

}  // namespace deltamesh::test
