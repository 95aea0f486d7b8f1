// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Any bytes into unpack_gltf(), as GLB or JSON. What comes out must be an asset without the extension.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "deltamesh/gltf.h"
#include "goal.h"

namespace {

using namespace deltamesh;

fuzz::Goal unpacked("an asset");

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const DecodeOptions options{
      .limits = {.vertices = 1U << 14, .triangles = 1U << 15, .attribute_bytes = 1U << 20}, .progress = {}};
  const auto plain = unpack_gltf(std::as_bytes(std::span(data, size)), options);
  if (!fuzz::check(plain)) return 0;
  const auto again = unpack_gltf(plain->asset, options);
  if (!again || again->report.converted != 0) std::abort();
  unpacked.reach();
  return 0;
}
