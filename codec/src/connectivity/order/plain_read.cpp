// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/byte_reader.h"
#include "base/numbers/zigzag.h"
#include "base/try.h"
#include "connectivity/plain_forms.h"
#include "entropy/planes.h"
#include "format/chunk/tags.h"

namespace deltamesh {
namespace {

/// Errors: kTruncated, kInvalidStream [ORDR-2].
Result<std::vector<std::uint32_t>> read_permutation(ByteReader& in, std::uint32_t count) {
  DELTAMESH_TRY(std::vector<std::uint32_t> places, read_planes(in, count));
  std::vector<std::uint8_t> seen(count, 0);
  std::uint32_t expected = 0;
  for (std::uint32_t& place : places) {
    place = expected + static_cast<std::uint32_t>(unzigzag(place));
    if (place >= count || seen[place] != 0) return in.invalid("not a permutation", "ORDR-2");
    seen[place] = 1;
    expected = place + 1;
  }
  return places;
}

}  // namespace

Result<MeshOrder> read_plain_order(std::span<const std::byte> bytes, std::uint32_t vertex_count,
                                   std::uint32_t triangle_count) {
  ByteReader in(bytes, kTagOrder);
  MeshOrder order;
  DELTAMESH_TRY(order.vertices, read_permutation(in, vertex_count));
  DELTAMESH_TRY(order.faces, read_permutation(in, triangle_count));
  DELTAMESH_TRY(const std::vector<std::uint32_t> rotations, read_planes(in, triangle_count));
  DELTAMESH_CHECK(in.finish());
  order.rotation.reserve(rotations.size());
  for (const std::uint32_t rotation : rotations) {
    if (rotation > 2) return in.invalid("rotation beyond 2", "ORDR-3");
    order.rotation.push_back(static_cast<std::uint8_t>(rotation));
  }
  return order;
}

}  // namespace deltamesh
