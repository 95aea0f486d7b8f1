// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Any bytes as a part of a map with a primer: an error, or a mesh whose indices are in range.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "map_part_codec.h"

using namespace deltamesh;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const MapCodec codec = fuzz::make_codec();
  const DecodeOptions options{
      .limits = {.vertices = 1U << 14, .triangles = 1U << 15, .attribute_bytes = 1U << 20}};
  const auto part = codec.decode(fuzz::kPart, std::as_bytes(std::span(data, size)), options);
  if (!part) {
    if (part.error().code == ErrorCode::kInternal) std::abort();
    return 0;
  }
  for (const std::uint32_t v : part->mesh.triangles)
    if (v >= part->mesh.vertex_count()) std::abort();
  for (const BorderVertex& border : part->border)
    if (border.vertex >= part->mesh.vertex_count()) std::abort();
  return 0;
}
