// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which primitives are compressed, and what goes into their streams.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "deltamesh/gltf.h"
#include "deltamesh/mesh.h"
#include "document.h"

namespace deltamesh::gltf {

struct CodedAttribute {
  std::string semantic;
  std::size_t accessor = 0;
  auto operator<=>(const CodedAttribute&) const = default;
};

/// What determines a stream: primitives with equal sources share one.
struct StreamSource {
  std::size_t position = 0;                ///< accessor
  std::optional<std::size_t> indices;      ///< accessor
  std::vector<CodedAttribute> attributes;  ///< in the order of the primitive; POSITION is not among them
  /// Something outside the stream counts on the vertices' numbers: morph targets, attributes that are not
  /// coded, unknown extensions.
  bool exact_order = false;
  auto operator<=>(const StreamSource&) const = default;
};

struct PrimitivePlan {
  std::size_t number = 0;  ///< over all meshes
  StreamSource source;
};

/// Plans for the primitives that are compressed; counts them, and the others by reason, in `report`. Errors:
/// kInvalidFile.
Result<std::vector<PrimitivePlan>> plan_primitives(const Document& document, GltfReport& report);

struct SourceMesh {
  Mesh mesh;
  std::uint64_t unreferenced_vertices = 0;  ///< left out
};

/// The mesh that goes into the stream, its attributes in the order of the source. Vertices that no triangle
/// uses are left out unless `keep_all`. `number` is named in errors. Errors: kInvalidFile.
Result<SourceMesh> build_mesh(const Document& document, const StreamSource& source, bool keep_all,
                              std::size_t number);

}  // namespace deltamesh::gltf
