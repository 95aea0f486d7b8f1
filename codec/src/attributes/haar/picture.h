// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What an encoder transforms: the vertices' values, in 64ths of a level, and the fields that say what they
// stand for.
#pragma once

#include <array>
#include <optional>

#include "attributes/haar/fields.h"
#include "attributes/rows.h"
#include "base/memory/large_vector.h"
#include "deltamesh/mesh.h"

namespace deltamesh {

/// By axis.
using HaarMean = std::array<float, kHaarAxes>;

struct HaarPicture {
  HaarFields fields;  ///< without the step
  unsigned components = kHaarAxes;
  LargeVector<HaarMean> values;  ///< n; of fields.axes axes
  LargeVector<HaarMean> alpha;   ///< n, of one axis, where it is coded; else empty
};

/// `rows`: of 3 or 4 components of `type`. Empty for other types than u8, u16 and f32, and for floats that
/// are not in [0, 1]. O(n).
std::optional<HaarPicture> picture_of_colors(ComponentType type, const AttributeRows& rows);

/// `rows`: of one component of `type`, u8, u16 or f32. Empty where all values are the same, or one is not
/// finite. O(n).
std::optional<HaarPicture> picture_of_numbers(ComponentType type, const AttributeRows& rows);

}  // namespace deltamesh
