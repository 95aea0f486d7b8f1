// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// ORDR payloads from anywhere. The last two bytes are the vertex count (and 128 for the compact form) and the
// face count. What is read must come back unchanged from both forms.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "connectivity/order/order.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace deltamesh;
  if (size < 2) return 0;
  const std::uint32_t vertices = data[size - 2] % 128U;
  const std::uint32_t faces = vertices == 0 ? 0 : data[size - 1];
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t corner = 0; corner < 3 * faces; ++corner)
    triangles.push_back((corner / 3 + corner % 3 * (1 + faces % 7)) % vertices);
  Payload payload(std::as_bytes(std::span(data, size - 2)));
  payload.is_compact = data[size - 2] >= 128;
  const auto order = read_order(payload, triangles, vertices);
  if (!order) {
    if (order.error().code == ErrorCode::kInternal) std::abort();
    return 0;
  }
  if (order->vertices.size() != vertices || order->faces.size() != faces || order->rotation.size() != faces)
    std::abort();
  const CodedOrder coded = write_order(*order, triangles);
  for (const Payload& form : {Payload(coded.payload), Payload::compact(coded.compact)}) {
    const auto again = read_order(form, triangles, vertices);
    if (!again || again->vertices != order->vertices || again->faces != order->faces ||
        again->rotation != order->rotation)
      std::abort();
  }
  return 0;
}
