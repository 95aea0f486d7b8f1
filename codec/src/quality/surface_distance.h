// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How far the vertices of two meshes are from each other's surface.
#pragma once

#include "deltamesh/compare.h"

namespace deltamesh {

/// Sets the distances, the angles of normals, the diagonal and the signed errors. Both meshes have passed
/// check_mesh(). O((n + m) log m). Errors: kInvalidArgument where one mesh is empty.
Result<void> compare_surfaces(const MeshView& a, const MeshView& b, Comparison& result);

}  // namespace deltamesh
