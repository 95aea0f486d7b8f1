// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The content of SEAM in every form: how many copies a geometric vertex has, and which one a corner uses.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "connectivity/seams/seams.h"

namespace deltamesh {

/// The copies of a geometric vertex are numbered by first use.
struct CornerCopies {
  std::vector<std::uint32_t> of_vertex;  ///< number of copies of every geometric vertex, at least 1
  std::vector<std::uint32_t> of_corner;  ///< copy that every corner uses
};

/// The faces over the copies [SEAM-5]. O(vertices + corners).
SplitVertices split_vertices(std::span<const std::uint32_t> geometric_triangles, const CornerCopies& copies);

}  // namespace deltamesh
