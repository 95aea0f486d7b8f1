// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>

#include "base/byte_reader.h"
#include "base/try.h"
#include "connectivity/plain/topology.h"
#include "deltamesh/mesh.h"
#include "entropy/arrays.h"
#include "format/chunk/tags.h"

namespace deltamesh {
namespace {

bool all_below(std::span<const std::uint32_t> numbers, std::uint32_t limit) noexcept {
  return std::all_of(numbers.begin(), numbers.end(), [limit](std::uint32_t x) { return x < limit; });
}

}  // namespace

Result<std::vector<std::uint32_t>> read_plain_faces(std::span<const std::byte> payload,
                                                    std::uint32_t triangle_count,
                                                    std::uint32_t vertex_count) {
  ByteReader in(payload, kTagConnectivity);
  DELTAMESH_TRY(auto triangles, read_indices(in, 3 * std::uint64_t{triangle_count}));
  DELTAMESH_CHECK(in.finish());
  if (!all_below(triangles, vertex_count)) return in.invalid("a face with a vertex out of range", "PLN-2");
  return triangles;
}

Result<std::vector<std::uint32_t>> read_plain_seams(std::span<const std::byte> payload,
                                                    std::uint32_t geometric_count,
                                                    std::uint32_t vertex_count) {
  ByteReader in(payload, kTagSeams);
  std::vector<std::uint32_t> geometric;
  if (vertex_count != geometric_count) {
    DELTAMESH_TRY(geometric, read_indices(in, vertex_count));
  }
  DELTAMESH_CHECK(in.finish());
  std::uint32_t fresh = 0;
  for (const std::uint32_t g : geometric) {
    if (g > fresh) return in.invalid("a geometric vertex before the one below it", "PLN-3");
    fresh += g == fresh ? 1 : 0;
  }
  if (!geometric.empty() && fresh != geometric_count)
    return in.invalid("another number of geometric vertices than declared", "PLN-3");
  return geometric;
}

Result<std::vector<std::uint32_t>> read_plain_groups(std::span<const std::byte> payload,
                                                     std::uint32_t triangle_count) {
  ByteReader in(payload, kTagFaceGroups);
  if (payload.empty()) return std::vector<std::uint32_t>();
  DELTAMESH_TRY(auto groups, read_array(in, triangle_count));
  DELTAMESH_CHECK(in.finish());
  if (!all_below(groups, kMostGroups)) return in.invalid("not the number of a group of faces", "FGRP-1");
  return groups;
}

}  // namespace deltamesh
