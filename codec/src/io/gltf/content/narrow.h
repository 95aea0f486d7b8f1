// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Values that glTF's attributes cannot have: other types, directions of another length than 1.
#pragma once

#include <cstddef>
#include <vector>

#include "base/numbers/vec3.h"
#include "deltamesh/io.h"

namespace deltamesh {

/// `attribute` itself where its type is one of glTF's. Else its values as the narrowest integers that hold
/// them all, or as float32; `report` gets the number of vertices whose values are not the same then. `kept`
/// owns what was made.
AttributeView with_gltf_type(const AttributeView& attribute, std::vector<Attribute>& kept,
                             WriteReport& report);

/// The direction at a vertex. Unit length is the law in glTF (3.7.2.1): others are scaled to it; zero or NaN
/// become `otherwise`.
Vec3 unit_direction(const AttributeView& attribute, std::size_t vertex, const Vec3& otherwise) noexcept;

}  // namespace deltamesh
