// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Any bytes into pack_gltf(), as GLB or JSON; an odd last byte asks for the fallback. What is packed must
// unpack.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "deltamesh/gltf.h"
#include "goal.h"

namespace {

using namespace deltamesh;

fuzz::Goal packed_and_back("an asset");

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  GltfPackOptions options;
  options.fallback = data[size - 1] % 2 != 0;
  const auto packed = pack_gltf(std::as_bytes(std::span(data, size - 1)), options);
  if (!fuzz::check(packed)) return 0;
  // A primitive that came with the extension may be wrong; one that we packed may not.
  if (packed->report.otherwise_compressed != 0) return 0;
  const auto plain = unpack_gltf(packed->asset);
  if (!plain || plain->report.converted != packed->report.converted) std::abort();
  packed_and_back.reach();
  return 0;
}
