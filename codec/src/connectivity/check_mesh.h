// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Validation of a mesh for the encoder, maps, compare() and the writers of files.
#pragma once

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// Sizes agree, indices are in range, counts within the format's; coordinates are finite unless `finite` is
/// false. Errors: kInvalidMesh naming the first triangle or attribute at fault; kNotFinite naming the first
/// vertex; kLimitExceeded.
Result<void> check_mesh(const MeshView& mesh, bool finite = true) noexcept;

}  // namespace deltamesh
