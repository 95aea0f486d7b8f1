// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Joints and weights of skinned vertices: four joints, exact, and their weights, within a bound and with the
// same sum [ATTR-60 .. ATTR-65].
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "attributes/rows.h"
#include "attributes/skin/joint_guesses.h"
#include "attributes/surface.h"
#include "attributes/values.h"
#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// `attribute`: 4 x u8 or u16. O(n + m).
CodedValues<std::byte> write_joints(const AttributeView& attribute, const AttributeRows& rows,
                                    const AttributeSurface& surface);

/// `attribute`: 4 x f32, u8 or u16. No weight, as a part of 1, is off by more than `bound`; each vertex'
/// weights add up to 1, and those that are 0 stay so. `others`: see write_attribute(). Empty where the
/// source's do not add up to 1, or `bound` asks for more than 16 bits. O(n + m).
std::optional<CodedValues<std::byte>> write_weights(const AttributeView& attribute, const AttributeRows& rows,
                                                    double bound, const AttributeSurface& surface,
                                                    std::span<const Attribute> others);

/// The values of `shape`, whose own are not looked at, 4 x u8 or u16. Errors: kTruncated, kInvalidStream
/// [ATTR-60, CMP-3].
Result<std::vector<std::byte>> read_joints(std::span<const std::byte> bytes, const Attribute& shape,
                                           const AttributeSurface& surface);

/// The same of 4 x f32, u8 or u16. `joints`: joints_of_weights(). Errors: kTruncated, kInvalidStream
/// [ATTR-63, ATTR-65, CMP-3].
Result<std::vector<std::byte>> read_weights(std::span<const std::byte> bytes, const Attribute& shape,
                                            const AttributeSurface& surface,
                                            std::span<const JointRow> joints);

}  // namespace deltamesh
