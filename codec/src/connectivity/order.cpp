// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "connectivity/order.h"

#include <utility>

#include "base/byte_reader.h"
#include "base/byte_writer.h"
#include "base/zigzag.h"
#include "entropy/planes.h"
#include "format/tags.h"

namespace deltamesh {
namespace {

/// Differences to the place that follows the one before, so that runs in order are runs of zeros [ORDR-1].
void write_permutation(ByteWriter& out, std::span<const std::uint32_t> places) {
  std::vector<std::uint32_t> symbols;
  symbols.reserve(places.size());
  std::uint32_t expected = 0;
  for (const std::uint32_t place : places) {
    symbols.push_back(zigzag(static_cast<std::int32_t>(place - expected)));
    expected = place + 1;
  }
  write_planes(out, symbols);
}

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

}  // namespace

std::vector<std::byte> write_order(const MeshOrder& order) {
  ByteWriter out;
  write_permutation(out, order.vertices);
  write_permutation(out, order.faces);
  write_planes(out, std::vector<std::uint32_t>(order.rotation.begin(), order.rotation.end()));
  return out.take();
}

Result<MeshOrder> read_order(std::span<const std::byte> payload, std::uint32_t vertex_count,
                             std::uint32_t triangle_count) {
  ByteReader in(payload, kTagOrder);
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

}  // namespace deltamesh
