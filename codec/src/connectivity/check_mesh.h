// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Validation of a mesh for the encoder, maps and compare().
#pragma once

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// Sizes agree, indices are in range, coordinates finite, counts within the format's. Errors: kInvalidMesh
/// naming the first triangle or attribute at fault; kNotFinite naming the first vertex; kLimitExceeded.
Result<void> check_mesh(const MeshView& mesh);

}  // namespace deltamesh
