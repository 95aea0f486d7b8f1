// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Any bytes into inspect() and decode(); success is checked too.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "deltamesh/decode.h"
#include "deltamesh/stream_info.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace deltamesh;
  const std::span<const std::byte> stream(reinterpret_cast<const std::byte*>(data), size);
  const auto info = inspect(stream);
  const auto mesh =
      decode(stream, {.limits = {.vertices = 1U << 16, .triangles = 1U << 17, .attribute_bytes = 1U << 24}});
  if (!mesh) {
    if (mesh.error().code == ErrorCode::kInternal) std::abort();
    return 0;
  }
  if (!info || info->vertices != mesh->vertex_count() || info->triangles != mesh->triangle_count())
    std::abort();
  for (const std::uint32_t v : mesh->triangles) {
    if (v >= mesh->vertex_count()) std::abort();
  }
  for (const float x : mesh->positions) {
    if (!std::isfinite(x)) std::abort();
  }
  return 0;
}
