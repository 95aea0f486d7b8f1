// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a primitive of the asset gives to a stream.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "accessor_store.h"
#include "deltamesh/gltf.h"
#include "document.h"
#include "semantics.h"

namespace deltamesh::gltf {

struct SourceAttribute {
  Semantic semantic;
  std::size_t accessor = 0;
};

/// glTF's modes of triangles.
enum class TriangleMode : std::uint8_t { kList = 4, kStrip = 5, kFan = 6 };

struct PrimitiveSource {
  std::size_t number = 0;  ///< over all meshes
  TriangleMode mode = TriangleMode::kList;
  std::size_t mesh = 0;
  std::size_t position = 0;              ///< accessor
  std::optional<std::size_t> indices{};  ///< accessor
  /// Those that go into the stream, in the order of the primitive; then those of its morph targets. POSITION
  /// itself is not among them.
  std::vector<SourceAttribute> attributes{};
  /// Something outside the stream counts on the vertices' numbers: attributes that are not coded, or unknown
  /// extensions.
  bool exact_order = false;
};

/// The primitives that can be compressed; counts them, and the others by reason, in `report`. Their accessors
/// are in `store` afterwards. Errors: kInvalidFile, kLimitExceeded.
Result<std::vector<PrimitiveSource>> find_sources(const Document& document, AccessorStore& store,
                                                  GltfReport& report);

}  // namespace deltamesh::gltf
