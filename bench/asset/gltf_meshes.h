// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Takes assets apart: meshes and their primitives before packing, streams and plain morph targets after it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "asset/part.h"
#include "asset/source.h"
#include "deltamesh/gltf.h"

namespace deltamesh::bench {

/// Every mesh with triangle lists of float positions; others are left out. Errors: load_document()'s,
/// kInvalidFile.
Result<Asset> meshes_of_asset(std::span<const std::byte> bytes, const GltfIo& io);

struct PackedAsset {
  std::vector<std::vector<std::byte>> streams;  ///< in the order of the primitives, each once
  std::uint64_t morph_bytes = 0;  ///< of the accessors that morph targets have outside of streams, each once
  std::uint64_t plain_bytes = 0;  ///< the same of vertex attributes
};

/// `bytes`: a GLB from pack_gltf(). Errors: kInvalidFile.
Result<PackedAsset> take_packed_apart(std::span<const std::byte> bytes);

}  // namespace deltamesh::bench
