// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which vertices of a base have colours that will do for a newer source.
#pragma once

#include <cstdint>
#include <vector>

#include "deltamesh/attribute_quality.h"
#include "deltamesh/mesh.h"

namespace deltamesh {

/// Whether vertex `b` of the base keeps what is asked of the colours of vertex `s`: a largest error, or four
/// times a mean one. On the border it has those that other parts give it [MAP-24]. All attributes of both are
/// colours of one shape.
bool keeps_colors(const Mesh& source, std::uint32_t s, const Mesh& base, std::uint32_t b,
                  const AttributeQuality& quality, bool is_border) noexcept;

/// Where a mean error is asked: of the vertices that have one in `base_of`, those with the least errors keep
/// it, as many as have that mean error together; the others get kNotJoined. O(n log n).
void keep_mean_error(const Mesh& source, const Mesh& base, const AttributeQuality& quality,
                     std::vector<std::uint32_t>& base_of);

}  // namespace deltamesh
