// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/broken_rule.h"
#include "base/byte_reader.h"
#include "base/zigzag.h"
#include "connectivity/order.h"
#include "connectivity/order_coder.h"
#include "entropy/compact_reader.h"
#include "entropy/planes.h"
#include "format/tags.h"

namespace deltamesh {
namespace {

/// Errors: kTruncated, kInvalidStream [ORDR-2].
Result<std::vector<std::uint32_t>> read_permutation(ByteReader& in, std::uint32_t count) {
  DELTAMESH_TRY(std::vector<std::uint32_t> places, read_planes(in, count));
  std::vector<std::uint8_t> seen(count, 0);
  std::uint32_t expected = 0;
  for (std::uint32_t& place : places) {
    place = expected + static_cast<std::uint32_t>(unzigzag(place));
    if (place >= count || seen[place] != 0)
      return in.error(ErrorCode::kInvalidStream, "not a permutation", "ORDR-2");
    seen[place] = 1;
    expected = place + 1;
  }
  return places;
}

/// Errors: kTruncated, kInvalidStream [ORDR-1 .. 3].
Result<MeshOrder> read_plain(std::span<const std::byte> bytes, std::uint32_t vertex_count,
                             std::uint32_t triangle_count) {
  ByteReader in(bytes, kTagOrder);
  MeshOrder order;
  DELTAMESH_TRY(order.vertices, read_permutation(in, vertex_count));
  DELTAMESH_TRY(order.faces, read_permutation(in, triangle_count));
  DELTAMESH_TRY(const std::vector<std::uint32_t> rotations, read_planes(in, triangle_count));
  DELTAMESH_CHECK(in.finish());
  order.rotation.reserve(rotations.size());
  for (const std::uint32_t rotation : rotations) {
    if (rotation > 2) return in.error(ErrorCode::kInvalidStream, "rotation beyond 2", "ORDR-3");
    order.rotation.push_back(static_cast<std::uint8_t>(rotation));
  }
  return order;
}

/// Errors: kTruncated, kInvalidStream [ORDR-2 .. 6, CMP-3].
Result<MeshOrder> read_compact(std::span<const std::byte> bytes, std::span<const std::uint32_t> triangles,
                               std::uint32_t vertex_count) {
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
  if (payload.is_compact) return read_compact(payload.bytes, triangles, vertex_count);
  return read_plain(payload.bytes, vertex_count, static_cast<std::uint32_t>(triangles.size() / 3));
}

}  // namespace deltamesh
