// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a part keeps of its border's colours: the same for all parts of which the same is asked.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/attribute_quality.h"
#include "deltamesh/map/part.h"
#include "lattice/border_payload.h"

namespace deltamesh {

/// The step of levels whose rounding keeps what is asked; 0 where that is exact, or so near that levels of 8
/// bits do not keep it: then copies of u16 and f32 may differ by what is asked.
std::uint32_t border_step(ComponentType type, const AttributeQuality& quality) noexcept;

/// The part's mesh. Where colours have a largest error, its border has the colours that it will have, for 1
/// to 3 % fewer bytes; rounded ones cost more at a mean error.
Mesh with_border_colors(const MapPart& part, const AttributeQuality& quality);

/// Of every attribute that is colours. `border`: of coded vertices; `order`: the source's vertex for each.
std::vector<BorderColors> border_colors(const Mesh& source, std::span<const BorderVertex> border,
                                        std::span<const std::uint32_t> order,
                                        const AttributeQuality& quality);

}  // namespace deltamesh
