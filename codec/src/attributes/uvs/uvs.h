// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Texture coordinates within a distance of the source's, predicted from the surface [ATTR-30 to ATTR-37].
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "attributes/surface.h"
#include "attributes/values.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// `uvs`: n x 2, by coded vertex. `max_distance`: the largest Euclidean distance in texture space, above 0.
/// Empty where a coordinate is not finite, or the bound is too small or too large for the coordinates' range.
/// O(n + m).
std::optional<CodedValues<float>> write_surface_uvs(std::span<const float> uvs, double max_distance,
                                                    const AttributeSurface& surface);

/// n x 2. Errors: kTruncated, kInvalidStream [ATTR-31, ATTR-37, CMP-3].
Result<std::vector<float>> read_surface_uvs(std::span<const std::byte> bytes,
                                            const AttributeSurface& surface);

}  // namespace deltamesh
