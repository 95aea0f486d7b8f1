// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Positions of an accessor as floats.
#pragma once

#include <array>

#include "accessor.h"

namespace deltamesh::gltf {

/// Row `i`. Integers become the float they stand for: their value, or where normalized this over the largest
/// of the type, rounded once. Precondition: is_position_shape().
std::array<float, 3> position_of(const AccessorRows& rows, std::uint64_t i) noexcept;

}  // namespace deltamesh::gltf
