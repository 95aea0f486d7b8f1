// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Any bytes into inspect() and decode(), with one thread and with two; success is checked too.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "deltamesh/decode.h"
#include "deltamesh/stream_info.h"
#include "goal.h"

namespace {

using namespace deltamesh;

fuzz::Goal mesh_decoded("a stream");

bool has_same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  const auto is_same = [](float x, float y) {
    return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), is_same);
}

bool is_same(const Result<Mesh>& a, const Result<Mesh>& b) {
  if (!a || !b) return !a && !b && a.error().code == b.error().code;
  if (a->attributes.size() != b->attributes.size()) return false;
  for (std::size_t i = 0; i < a->attributes.size(); ++i) {
    if (a->attributes[i].values != b->attributes[i].values) return false;
  }
  return a->triangles == b->triangles && has_same_bits(a->positions, b->positions);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::byte> stream(reinterpret_cast<const std::byte*>(data), size);
  const DecodeOptions options{
      .limits = {.vertices = 1U << 16, .triangles = 1U << 17, .attribute_bytes = 1U << 24}};
  const auto info = inspect(stream);
  const auto mesh = decode(stream, options);
  DecodeOptions shared = options;
  shared.threads = 2;
  if (!is_same(decode(stream, shared), mesh)) std::abort();
  if (!fuzz::check(mesh)) return 0;
  if (!info || info->vertices != mesh->vertex_count() || info->triangles != mesh->triangle_count())
    std::abort();
  for (const std::uint32_t v : mesh->triangles) {
    if (v >= mesh->vertex_count()) std::abort();
  }
  for (const float x : mesh->positions) {
    if (!std::isfinite(x)) std::abort();
  }
  mesh_decoded.reach();
  return 0;
}
