// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which attributes the primitives of a glTF asset have in common, and their values in the merged mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "deltamesh/io.h"
#include "io/gltf/accessor.h"
#include "io/gltf/scene.h"

namespace deltamesh::gltf {

/// The shape of an accessor that is read as it is, and its rows: zeros where it has no data, for which the
/// caller has bounded the count. Errors: kInvalidFile, also where another extension holds the data.
Result<AccessorShape> plain_shape(const Document& document, std::size_t accessor);
Result<AccessorRows> plain_rows(const Document& document, std::size_t accessor);

/// Vertices that one or more primitives of a placed mesh share.
struct VertexSet {
  std::map<std::string, std::size_t> semantics;  ///< accessors of the primitives
  const Transform* transform = nullptr;
  std::uint64_t first = 0;  ///< vertex in the merged mesh
  std::uint64_t count = 0;
};

/// All attributes but the position, of `vertices` vertices. NORMAL, TANGENT and TEXCOORD_n become float32,
/// normals and tangents are turned with their node. Where the sets differ: a colour that some lack is filled
/// with opaque white, tangents with x, normals with z, the rest with 0, which `report` is told; colours and
/// weights of several types become float32, joints u16. A custom attribute that a set lacks, or has in
/// another type, and one whose name is not UTF-8 of 1 to 255 bytes, is left out and told to `report`. Errors:
/// kInvalidFile: a semantic with a wrong type or count, accessors out of range.
Result<std::vector<Attribute>> merge_attributes(const Document& document, const std::vector<VertexSet>& sets,
                                                std::uint64_t vertices, ReadReport& report);

}  // namespace deltamesh::gltf
