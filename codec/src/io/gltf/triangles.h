// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Primitives that draw triangles: what they refer to, their corners, and the normals of their faces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "io/gltf/accessor.h"
#include "io/gltf/structure.h"

namespace deltamesh::gltf {

/// glTF's modes of triangles.
enum class TriangleMode : std::uint8_t { kList = 4, kStrip = 5, kFan = 6 };

struct TrianglePrimitive {
  PrimitiveNumber number{};
  TriangleMode mode = TriangleMode::kList;
  std::size_t position = 0;              ///< accessor
  std::optional<std::size_t> indices{};  ///< accessor
};

/// Nothing for points and lines, and where there are no positions. Precondition: check_structure(). Errors:
/// kInvalidFile.
Result<std::optional<TrianglePrimitive>> triangle_primitive(const Json& primitive,
                                                            const PrimitiveNumber& number);

/// Corners of whole triangles, as numbers of vertices, all below `vertices`. `indices`: null where the
/// vertices themselves are the corners. Strips and fans become lists. Errors: kInvalidFile (an index beyond
/// the vertices, indices that are no unsigned integers), kLimitExceeded.
Result<std::vector<std::uint32_t>> triangle_corners(const TrianglePrimitive& primitive,
                                                    std::uint64_t vertices, const AccessorRows* indices);

/// Writes three floats, the unit normal of the faces around by their areas, into the rows of `normals` of all
/// vertices that `corners` names; rows of vertices without such a normal stay. `corners`: three for each
/// triangle.
void write_face_normals(const Mesh& mesh, std::span<const std::uint32_t> corners,
                        std::span<std::byte> normals);

}  // namespace deltamesh::gltf
