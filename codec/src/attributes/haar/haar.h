// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Colours and numbers of the vertices of a surface at a mean error: a transform over the mesh [ATTR-66,
// HAAR-*].
#pragma once

#include <cstddef>
#include <cstdint>
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

struct HaarModels;

/// The factor, up or down, by which a mean error may be off that nobody is promised.
inline constexpr double kAbout = 1.5;

/// `rows`: of 3 or 4 components of `type`. `rms`: the root mean square of the errors of all values of red,
/// green and blue, 255ths of their range, above 0, and of those of alpha; it is met within 1 % from below,
/// unless nothing is left to be saved. Empty for other types than u8, u16 and f32, for floats that are not in
/// [0, 1], and where levels of 8 bits cannot keep `rms`. `start`: null for fresh models. `about`: the
/// error may be off by kAbout, which mostly takes one trial. O(n) for each of a few trials.
std::optional<CodedValues<std::byte>> write_haar_colors(ComponentType type, const AttributeRows& rows,
                                                        double rms, const AttributeSurface& surface,
                                                        const HaarModels* start = nullptr,
                                                        bool about = false);

/// `rows`: of one component of `type`, u8, u16 or f32. `rms`: likewise, in the unit of the numbers. Empty for
/// numbers that are not finite or all the same, and where 255 levels and their 64ths cannot keep `rms`.
std::optional<CodedValues<std::byte>> write_haar_numbers(ComponentType type, const AttributeRows& rows,
                                                         double rms, const AttributeSurface& surface,
                                                         const HaarModels* start = nullptr,
                                                         bool about = false);

/// The values. O(n), without recursion. Errors: kTruncated, kInvalidStream [HAAR-6, CMP-3].
Result<std::vector<std::byte>> read_haar_values(std::span<const std::byte> bytes, const Attribute& shape,
                                                const AttributeSurface& surface,
                                                const Learning<HaarModels>& learning = {});

}  // namespace deltamesh
