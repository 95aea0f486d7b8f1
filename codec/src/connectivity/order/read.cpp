// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/broken_rule.h"
#include "base/try.h"
#include "connectivity/order/coder.h"
#include "connectivity/order/order.h"
#include "connectivity/plain_forms.h"
#include "entropy/coder/reader.h"
#include "format/chunk/tags.h"

namespace deltamesh {
namespace {

/// Errors: kTruncated, kInvalidStream [ORDR-2 .. 6, CMP-3].
Result<MeshOrder> read_compact_order(std::span<const std::byte> bytes,
                                     std::span<const std::uint32_t> triangles, std::uint32_t vertex_count) {
  const std::size_t face_count = triangles.size() / 3;
  MeshOrder order{std::vector<std::uint32_t>(vertex_count), std::vector<std::uint32_t>(face_count),
                  std::vector<std::uint8_t>(face_count)};
  CompactReader reader(bytes);
  const char* const broken = OrderCoder<CompactReader>(reader, triangles, vertex_count).code(order);
  if (reader.failed() || broken == nullptr) DELTAMESH_CHECK(reader.finish(kTagOrder));
  if (broken != nullptr) return broken_rule("not a permutation, or a rotation beyond 2", broken, kTagOrder);
  return order;
}

}  // namespace

Result<MeshOrder> read_order(Payload payload, std::span<const std::uint32_t> triangles,
                             std::uint32_t vertex_count) {
  if (payload.is_compact) return read_compact_order(payload.bytes, triangles, vertex_count);
  return read_plain_order(payload.bytes, vertex_count, static_cast<std::uint32_t>(triangles.size() / 3));
}

}  // namespace deltamesh
