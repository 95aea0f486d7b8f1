// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Colours of the vertices of a surface, exact or within a bound on the error of every component [ATTR-45 ..
// ATTR-52].
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "attributes/rows.h"
#include "attributes/surface.h"
#include "attributes/values.h"
#include "deltamesh/mesh.h"
#include "deltamesh/result.h"
#include "entropy/coder/learning.h"

namespace deltamesh {

struct ColorModels;

/// `rows`: of 1 to 4 components of `type`. `max_error`: the largest error of a component, 255ths of its
/// range, 0 or above. Empty for other types than u8, u16 and f32, for floats that are not in [0, 1], and for
/// exact floats that are not all whole 255ths or whole 65535ths. `start`: null for fresh models. `known`:
/// what readers have of the surface's known vertices, or null. `former_error`: former colours stay where they
/// are off by no more, in the same units, even if that is above `max_error`. O(n).
std::optional<CodedValues<std::byte>> write_surface_colors(ComponentType type, const AttributeRows& rows,
                                                           double max_error, const AttributeSurface& surface,
                                                           const ColorModels* start = nullptr,
                                                           const Attribute* known = nullptr,
                                                           double former_error = 0);

/// The values. Errors: kTruncated, kInvalidStream [ATTR-45, CMP-3].
Result<std::vector<std::byte>> read_surface_colors(std::span<const std::byte> bytes, ComponentType type,
                                                   unsigned components, const AttributeSurface& surface,
                                                   const Learning<ColorModels>& learning = {},
                                                   const Attribute* known = nullptr);

}  // namespace deltamesh
