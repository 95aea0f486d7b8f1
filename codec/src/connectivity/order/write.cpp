// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "connectivity/order/coder.h"
#include "connectivity/order/order.h"
#include "entropy/coder/writer.h"

namespace deltamesh {
std::vector<std::byte> write_order(MeshOrder order, std::span<const std::uint32_t> triangles) {
  CompactWriter writer;
  OrderCoder<CompactWriter>(writer, triangles, static_cast<std::uint32_t>(order.vertices.size())).code(order);
  return writer.finish();
}

}  // namespace deltamesh
