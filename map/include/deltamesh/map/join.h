// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From parts to one mesh.
#pragma once

#include <span>

#include "deltamesh/map/part.h"
#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// All faces of `parts`, in their order. Border vertices with the same point and twin are one vertex where
/// all their attributes are bit by bit equal. So every face keeps the attributes of its part, with their
/// bounds, and exact ones and colours [MAP-24] are shared as in the source. Normals, texture coordinates and
/// tangents within bounds differ a little from part to part: there each part keeps a vertex of its own, at a
/// position with the same bits, as at the source's seams. Precondition: all parts have the same attributes
/// and origin. O(n log n). Errors: kInvalidArgument, kOutOfMemory.
Result<Mesh> join(std::span<const MapPart> parts) noexcept;

}  // namespace deltamesh
