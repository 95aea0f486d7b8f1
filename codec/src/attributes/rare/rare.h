// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Compact codings that few streams have: numbers on lattices, joints, weights, colours at a mean error.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "attributes/payload.h"
#include "attributes/skin/skin.h"
#include "attributes/surface.h"
#include "deltamesh/mesh.h"
#include "deltamesh/result.h"
#include "entropy/coder/learning.h"

namespace deltamesh {

struct AttributeModels;

constexpr bool is_rare(AttributeCoding coding) noexcept { return coding >= AttributeCoding::kLattice; }

/// The values of `shape`, whose own are not looked at. `coding`: which is rare, and fits. `joints`: of
/// weights, of every vertex. Errors: as those of each coding.
Result<std::vector<std::byte>> read_rare_values(AttributeCoding coding, std::span<const std::byte> bytes,
                                                const Attribute& shape, const AttributeSurface& surface,
                                                std::span<const JointRow> joints,
                                                const Learning<AttributeModels>& learning = {});

}  // namespace deltamesh
