// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// ATTR payloads from anywhere. The last byte is the vertex count. What is read must be whole, and must come
// back unchanged when written exactly.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <span>
#include <vector>

#include "attributes/attribute.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace deltamesh;
  if (size == 0) return 0;
  const std::uint32_t vertices = data[size - 1];
  const auto bytes = std::as_bytes(std::span(data, size - 1));
  const auto read = read_attribute(std::vector<std::byte>(bytes.begin(), bytes.end()), vertices, 1 << 16);
  if (!read) {
    if (read.error().code == ErrorCode::kInternal) std::abort();
    return 0;
  }
  if (read->values.size() != vertices * read->components * component_size(read->type)) std::abort();

  std::vector<std::uint32_t> order(vertices);
  std::iota(order.begin(), order.end(), 0U);
  const AttributeView exact{AttributeKind::kGeneric, read->type, read->components,
                            read->normalized,        read->name, read->values};
  const auto written = write_attribute(exact, order, {});
  if (!written) std::abort();
  const auto again = read_attribute(*written, vertices, 1 << 16);
  if (!again || again->values != read->values) std::abort();
  return 0;
}
