// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// ORDR payloads from anywhere. The last two bytes are the vertex count and the face count. What is read must
// come back unchanged when written.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "connectivity/order.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace deltamesh;
  if (size < 2) return 0;
  const std::uint32_t vertices = data[size - 2];
  const std::uint32_t faces = data[size - 1];
  const auto order = read_order(std::as_bytes(std::span(data, size - 2)), vertices, faces);
  if (!order) {
    if (order.error().code == ErrorCode::kInternal) std::abort();
    return 0;
  }
  if (order->vertices.size() != vertices || order->faces.size() != faces || order->rotation.size() != faces)
    std::abort();
  const auto again = read_order(write_order(*order), vertices, faces);
  if (!again || again->vertices != order->vertices || again->faces != order->faces ||
      again->rotation != order->rotation)
    std::abort();
  return 0;
}
