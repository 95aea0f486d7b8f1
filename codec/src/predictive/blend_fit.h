// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Blend weights that suit a mesh: weighted least squares per row of the table. Encoder only.
#pragma once

#include <span>

#include "predictive/blend.h"

namespace deltamesh {

/// `cells`: all vertices of `stars`. Rows of few vertices keep the usual weights. O(n).
BlendTable fit_blends(const FaceStars& stars, std::span<const Cell> cells);

}  // namespace deltamesh
