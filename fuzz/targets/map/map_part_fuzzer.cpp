// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Any bytes as a part of a map with a primer: an error, or a mesh whose indices are in range. The first byte
// says which part.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "goal.h"
#include "map_part_codec.h"

namespace {

using namespace deltamesh;

fuzz::Goal part_decoded("a part");

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const MapCodec codec = fuzz::make_codec();
  static const std::vector<MapPart> parts = fuzz::make_parts(codec.description());
  if (size == 0) return 0;
  const DecodeOptions options{
      .limits = {.vertices = 1U << 14, .triangles = 1U << 15, .attribute_bytes = 1U << 20}};
  const auto part =
      codec.decode(parts[data[0] % parts.size()].key, std::as_bytes(std::span(data + 1, size - 1)), options);
  if (!fuzz::check(part)) return 0;
  for (const std::uint32_t v : part->mesh.triangles)
    if (v >= part->mesh.vertex_count()) std::abort();
  for (const BorderVertex& border : part->border)
    if (border.vertex >= part->mesh.vertex_count()) std::abort();
  part_decoded.reach();
  return 0;
}
