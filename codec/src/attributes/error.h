// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The largest error of a decoded attribute, in the unit of its kind (AttributeInfo::error).
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "attributes/rows.h"
#include "base/numbers/portable_math.h"
#include "base/numbers/vec3.h"
#include "deltamesh/attribute_quality.h"
#include "deltamesh/mesh.h"

namespace deltamesh {

/// Whether the length of a normal or tangent is 1 about, so that only its direction is anything to keep.
inline bool is_unit(const Vec3& v) noexcept { return std::fabs(length(v) - 1) <= 1e-2; }

/// Whether it has a direction.
inline bool is_direction(const Vec3& v) noexcept { return v != Vec3{} && std::isfinite(dot(v, v)); }

/// Whether it has a direction and a side.
inline bool is_tangent(const Vec3& v, float side) noexcept { return is_direction(v) && std::fabs(side) == 1; }

/// Largest angles, degrees, that surface codings of directions can keep.
inline constexpr double kLeastAngle = 0.002;
inline constexpr double kMostAngle = 60;

/// The distance of unit vectors at an angle.
inline double chord_of(double degrees) noexcept { return 2 * portable_sin(degrees * (kPi / 360)); }

/// What one 255th of a colour's range is in its type.
double color_unit(ComponentType type) noexcept;
/// The bound on the error of `attribute`; 0: exact.
double bound_of(const AttributeView& attribute, const AttributeQuality& quality) noexcept;
/// The bound on its mean error, where one was asked for and a coding is for that: see attribute_rms().
std::optional<double> mean_bound_of(const AttributeView& attribute, const AttributeQuality& quality) noexcept;

/// How many normals or tangents have a length other than 1, which a bound on their angle does not keep; 0
/// where they are exact.
std::uint64_t count_dropped_lengths(const AttributeView& attribute, const AttributeQuality& quality);

/// `decoded`: rows.count() values of the shape of `attribute`, whose rows are `rows`. 0 where all bits are
/// the same; infinity where a difference is not a number. The same on every machine. O(n).
double attribute_error(const AttributeView& attribute, const AttributeRows& rows,
                       std::span<const std::byte> decoded);

/// The root mean square of the errors of all values of red, green and blue, 255ths of their range; the same
/// on every machine. `type`: u8, u16 or f32, finite; `rows`: of 3 components or more. O(n).
double color_rms(ComponentType type, const AttributeRows& rows, std::span<const std::byte> decoded) noexcept;
/// What a bound on the mean error is on: the larger one of color_rms() and the same of alpha, where there is
/// one, or that of numbers, of one component, in their unit.
double bounded_rms(ComponentType type, const AttributeRows& rows,
                   std::span<const std::byte> decoded) noexcept;
/// Of an attribute that mean_bound_of() has a bound for: color_rms(), or bounded_rms() of numbers.
double attribute_rms(const AttributeView& attribute, const AttributeRows& rows,
                     std::span<const std::byte> decoded) noexcept;

}  // namespace deltamesh
