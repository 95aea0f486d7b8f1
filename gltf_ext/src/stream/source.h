// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a primitive of the asset gives to a stream.
#pragma once

#include <cstddef>
#include <vector>

#include "deltamesh/gltf.h"
#include "document/semantics.h"
#include "io/gltf/triangles.h"
#include "stream/store.h"

namespace deltamesh::gltf {

struct SourceAttribute {
  Semantic semantic;
  std::size_t accessor = 0;
};

struct PrimitiveSource : TrianglePrimitive {
  /// Those that go into the stream, in the order of the primitive; then those of its morph targets. POSITION
  /// itself is not among them.
  std::vector<SourceAttribute> attributes{};
  /// See uv_scale_of().
  double uv_scale = 1;
  /// Something outside the stream counts on the vertices' numbers: attributes that are not coded, or unknown
  /// extensions.
  bool exact_order = false;
};

/// The primitives that can be compressed; counts them, and the others by reason, in `report`. Their accessors
/// are in `store` afterwards. Errors: kInvalidFile, kLimitExceeded.
Result<std::vector<PrimitiveSource>> find_sources(const Document& document, AccessorStore& store,
                                                  GltfReport& report);

}  // namespace deltamesh::gltf
