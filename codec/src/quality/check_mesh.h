// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What the encoder, maps and compare() ask of a mesh before they start.
#pragma once

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// Sizes agree, indices are in range, coordinates finite, counts within the format's. Errors: kInvalidMesh
/// naming the first vertex, triangle or attribute at fault; kLimitExceeded.
Result<void> check_mesh(const MeshView& mesh);

}  // namespace deltamesh
