// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Blend weights that suit a mesh: weighted least squares per row of the table. Encoder only.
#pragma once

#include <span>

#include "positions/blend/blend.h"

namespace deltamesh {

/// The criterion that fitted weights minimise.
enum class BlendFit {
  kSquares,  ///< sums of squares, far vertices weighing less
  kSample,   ///< the same of a sample of the vertices
  kBits,     ///< sums of logarithms: suits scans, and surfaces that weights can hit exactly
};

/// `cells`: all vertices of `stars`, of which enough are looked at. Rows of few vertices keep the usual
/// weights. O(n).
BlendTable fit_blends(const KnownFaces& faces, std::span<const Cell> cells, BlendFit fit);

}  // namespace deltamesh
