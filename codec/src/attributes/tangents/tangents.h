// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Tangents within an angle of the source's, predicted from the surface, its texture coordinates and normals
// [ATTR-38 to ATTR-44].
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "attributes/surface.h"
#include "attributes/values.h"
#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// The decoded normals and texture coordinates that tangents are predicted from. Both may be empty.
struct TangentBasis {
  std::vector<float> normals;  ///< n x 3, decoded
  std::vector<float> uvs;      ///< n x 2, decoded
};

/// The first normals and texture coordinates of floats among the decoded attributes [ATTR-39].
TangentBasis tangent_basis(std::span<const Attribute> decoded, std::uint32_t vertex_count);

/// `tangents`: n x 4, by coded vertex: a vector and a sign, 1 or -1. Every decoded vector is at most
/// `max_degrees` from its original, signs are the same. Empty where a vector is not finite or has a length
/// more than 1 % off 1, another sign occurs, or `max_degrees` is not between 0.002 and 60. O(n + m).
std::optional<CodedValues<float>> write_surface_tangents(std::span<const float> tangents, double max_degrees,
                                                         const AttributeSurface& surface,
                                                         const TangentBasis& basis);

/// n x 4. Errors: kTruncated, kInvalidStream [ATTR-38, ATTR-44, CMP-3].
Result<std::vector<float>> read_surface_tangents(std::span<const std::byte> bytes,
                                                 const AttributeSurface& surface, const TangentBasis& basis);

}  // namespace deltamesh
