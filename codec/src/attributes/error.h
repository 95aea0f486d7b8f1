// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The largest error of a decoded attribute, in the unit of its kind (AttributeInfo::error).
#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#include "attributes/rows.h"
#include "base/numbers/portable_math.h"
#include "base/numbers/vec3.h"
#include "deltamesh/mesh.h"

namespace deltamesh {

/// Normals and tangents of a length this far from 1 are data, not directions: they are stored exactly.
inline bool is_direction(const Vec3& v) noexcept { return std::fabs(length(v) - 1) <= 1e-2; }

/// Largest angles, degrees, that surface codings of directions can keep.
inline constexpr double kLeastAngle = 0.002;
inline constexpr double kMostAngle = 60;

/// The distance of unit vectors at an angle.
inline double chord_of(double degrees) noexcept { return 2 * portable_sin(degrees * (kPi / 360)); }

/// `decoded`: rows.count() values of the shape of `attribute`, whose rows are `rows`. 0 where all bits are
/// the same; infinity where a difference is not a number. The same on every machine. O(n).
double attribute_error(const AttributeView& attribute, const AttributeRows& rows,
                       std::span<const std::byte> decoded);

}  // namespace deltamesh
