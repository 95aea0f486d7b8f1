// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Normals within a largest angle of the original ones, predicted from the decoded surface and from normals
// that are coded already [ATTR-20 .. ATTR-25].
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "attributes/surface.h"
#include "attributes/values.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// `normals`: n x 3, by coded vertex. Every decoded normal is at most `max_degrees` from its original; zero
/// vectors stay zero. `surface.geometric()` must not fall from vertex to vertex. Empty where a normal is not
/// finite or, not being zero, has a length more than 1 % off 1, where no lattice point stands for one, or
/// where `max_degrees` is not between kLeastAngle and kMostAngle. O(n + m).
std::optional<CodedValues<float>> write_surface_normals(std::span<const float> normals, double max_degrees,
                                                        const AttributeSurface& surface);

/// n x 3 unit or zero vectors. Errors: kTruncated, kInvalidStream [ATTR-20, ATTR-24, CMP-3].
Result<std::vector<float>> read_surface_normals(std::span<const std::byte> bytes,
                                                const AttributeSurface& surface);

}  // namespace deltamesh
