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

/// All faces of `parts`, in their order. Vertices of different parts are one vertex where both are border
/// vertices with the same point and twin; its attributes are those of the first part. (Where a part has
/// several vertices there, as at texture seams, only those with equal attributes become one.) Precondition:
/// all parts have the same attributes and origin. O(n log n). Errors: kInvalidArgument, kOutOfMemory.
Result<Mesh> join(std::span<const MapPart> parts) noexcept;

}  // namespace deltamesh
