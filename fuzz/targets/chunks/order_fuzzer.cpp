// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// ORDR payloads from anywhere. The last two bytes are the vertex count and the face count. What is read must
// come back unchanged.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "connectivity/order/order.h"
#include "goal.h"
#include "meshes.h"

namespace {

using namespace deltamesh;

fuzz::Goal order_read("an order");

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const fuzz::SpreadFaces spread(data[size - 2], data[size - 1]);
  const auto& [vertices, faces, triangles, geometric] = spread;
  const auto payload = std::as_bytes(std::span(data, size - 2));
  const auto order = read_order(payload, triangles, vertices);
  if (!fuzz::check(order)) return 0;
  if (order->vertices.size() != vertices || order->faces.size() != faces || order->rotation.size() != faces)
    std::abort();
  const auto again = read_order(write_order(*order, triangles), triangles, vertices);
  if (!again || again->vertices != order->vertices || again->faces != order->faces ||
      again->rotation != order->rotation)
    std::abort();
  order_read.reach();
  return 0;
}
