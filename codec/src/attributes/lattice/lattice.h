// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Attributes of any kind as whole numbers, on lattices, from lists, or ordinals of floats, predicted from
// what is around [ATTR-55 .. ATTR-58].
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

namespace deltamesh {

/// No component of a value is off by more than `bound` (0: by no bit). `effort`: 0 does not try which
/// predictor is best. Empty where fit_lattices() is. O(m + n log n).
std::optional<CodedValues<std::byte>> write_lattice(const AttributeView& attribute, const AttributeRows& rows,
                                                    double bound, int effort,
                                                    const AttributeSurface& surface);

/// The values of `shape`, whose own are not looked at. Errors: kTruncated, kInvalidStream [ATTR-55, ATTR-56,
/// CMP-3].
Result<std::vector<std::byte>> read_lattice(std::span<const std::byte> bytes, const Attribute& shape,
                                            const AttributeSurface& surface);

}  // namespace deltamesh
