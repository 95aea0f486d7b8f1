// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Colours and numbers of the vertices of a surface at a mean error: a transform over the mesh [ATTR-66,
// HAAR-*].
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

struct HaarModels;

/// The factor, up or down, by which a mean error may be off that nobody is promised.
inline constexpr double kAbout = 1.5;

/// `rows`: colours, of 3 or 4 components of `type`, or numbers, of one. `rms`: the root mean square of the
/// errors of all values of red, green and blue, 255ths of their range, above 0, and of those of alpha, or of
/// the numbers, in their unit; it is met within 1 % from below, unless nothing is left to be saved. Empty for
/// other types than u8, u16 and f32, and where levels cannot keep `rms`: of colours of 8 bits, of numbers 255
/// and their 64ths. Also for colours of floats that are not in [0, 1], and for numbers that are not finite or
/// all the same. `start`: null for fresh models. `about`: the error may be off by kAbout, which mostly takes
/// one trial. O(n) for each of a few trials.
std::optional<CodedValues<std::byte>> write_haar_values(ComponentType type, const AttributeRows& rows,
                                                        double rms, const AttributeSurface& surface,
                                                        const HaarModels* start = nullptr,
                                                        bool about = false);

/// The values. O(n), without recursion. Errors: kTruncated, kInvalidStream [HAAR-6, CMP-3].
Result<std::vector<std::byte>> read_haar_values(std::span<const std::byte> bytes, const Attribute& shape,
                                                const AttributeSurface& surface,
                                                const Learning<HaarModels>& learning = {});

}  // namespace deltamesh
