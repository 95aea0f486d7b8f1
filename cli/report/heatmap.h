// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Errors as colours of a mesh, after Figure 9 of the paper.
#pragma once

#include <span>

#include "deltamesh/mesh.h"

namespace deltamesh::cli {

/// Error at which the colours saturate: the 95th percentile of the magnitudes, or the largest where that is
/// 0.
float heatmap_scale(std::span<const float> errors);

/// `mesh` without its attributes, coloured: green where there is no error, over yellow to red at `scale` and
/// more, over cyan to blue below 0. `errors`: one per vertex.
Mesh heatmap(const Mesh& mesh, std::span<const float> errors, float scale);

}  // namespace deltamesh::cli
