// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Normals for shading at a receiver, where a map comes without them: smooth across the borders of parts.
#pragma once

#include <span>
#include <vector>

#include "deltamesh/map/part.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// Of every vertex of a part a unit normal, n x 3: the sum of the normals of all faces at its position,
/// weighted by their areas; 0 0 1 where there is none. Vertices with equal positions have the same. `others`:
/// the parts beside it, in any order; more of them, or the part itself, change nothing. In every part that is
/// given all parts around a border vertex its normal has the same bits: make those of a part's neighbours
/// anew when it changes. O(n log n) for n vertices and faces of the part, O(n) for those of `others`. Errors:
/// kInvalidArgument (a face beyond the vertices), kOutOfMemory.
Result<std::vector<float>> smooth_normals(const MapPart& part,
                                          std::span<const MapPart* const> others) noexcept;

}  // namespace deltamesh
