// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Packing and unpacking that must succeed, and what to look at afterwards.
#pragma once

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "deltamesh/gltf.h"
#include "support/gltf_asset.h"

namespace deltamesh::test {

inline constexpr const char* kExtension = "DELTAMESH_mesh_compression";

inline GltfOutput pack_ok(const Bytes& asset, const GltfPackOptions& options = {}, const GltfIo& io = {}) {
  auto packed = pack_gltf(asset, options, io);
  EXPECT_TRUE(packed) << (packed ? "" : describe(packed.error()));
  return packed ? *std::move(packed) : GltfOutput{};
}

inline GltfOutput unpack_ok(const Bytes& asset) {
  auto unpacked = unpack_gltf(asset);
  EXPECT_TRUE(unpacked) << (unpacked ? "" : describe(unpacked.error()));
  return unpacked ? *std::move(unpacked) : GltfOutput{};
}

inline GltfPackOptions with_fallback() {
  GltfPackOptions options;
  options.fallback = true;
  return options;
}

inline GltfPackOptions lossless() {
  GltfPackOptions options;
  options.encode.lossless = true;
  return options;
}

inline std::vector<float> positions_of(const OpenedGlb& glb, const Json& primitive) {
  return glb.values<float>(primitive["attributes"]["POSITION"]);
}

/// Sum over triangles of twice the signed area seen from +z: the same for any order of vertices and
/// triangles.
inline double signed_area(const OpenedGlb& glb, const Json& primitive) {
  const auto p = positions_of(glb, primitive);
  const auto corners = glb.values<std::uint16_t>(primitive["indices"]);
  double sum = 0;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const float* a = &p[corners[i] * 3U];
    const float* b = &p[corners[i + 1] * 3U];
    const float* c = &p[corners[i + 2] * 3U];
    sum += double(b[0] - a[0]) * double(c[1] - a[1]) - double(b[1] - a[1]) * double(c[0] - a[0]);
  }
  return sum;
}

}  // namespace deltamesh::test
