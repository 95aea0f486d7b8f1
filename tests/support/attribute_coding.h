// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Attributes to payloads and back, for tests of single codings.
#pragma once

#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "attributes/attribute.h"
#include "support/attribute_of.h"

namespace deltamesh::test {

inline AttributeView view(const Attribute& a) {
  return {a.kind, a.type, a.components, a.normalized, a.name, a.values, a.linear};
}

inline std::uint32_t rows(const Attribute& a) {
  return static_cast<std::uint32_t>(a.values.size() / (a.components * component_size(a.type)));
}

inline std::vector<std::uint32_t> identity(std::uint32_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  return order;
}

/// Bounds that no coding may use: everything is exact.
inline const AttributeQuality kExactly{.normal_error = 0, .uv_error = 0, .weight_error = 0};

/// In plain form, of vertices that no face joins.
inline Result<CodedAttribute> write_plain(const Attribute& a, std::span<const std::uint32_t> order,
                                          const AttributeQuality& quality = {}) {
  const AttributeSurface surface({}, static_cast<std::uint32_t>(order.size()));
  return write_attribute(view(a), order, {.quality = quality, .plain = true}, surface, {});
}

inline Result<Attribute> read_plain(std::span<const std::byte> payload, const AttributeDescriptor& descriptor,
                                    std::uint32_t vertices, std::uint64_t max_bytes = ~std::uint64_t{0}) {
  return read_attribute(Payload(payload), descriptor, AttributeSurface({}, vertices), {}, max_bytes);
}

}  // namespace deltamesh::test
