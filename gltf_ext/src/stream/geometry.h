// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Measures of a merged mesh by its groups.
#pragma once

#include <cstdint>
#include <vector>

#include "stream/plan.h"

namespace deltamesh::gltf {

/// The smallest diagonal of the bounding box of a mesh of the asset over that of the whole stream: above 0,
/// at most 1. `corners`: by group.
double smallest_diagonal_share(const Mesh& mesh, const std::vector<std::vector<std::uint32_t>>& corners,
                               const std::vector<PrimitiveSource>& sources, const StreamPlan& plan);

}  // namespace deltamesh::gltf
