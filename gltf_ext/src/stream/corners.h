// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The triangles of a primitive of the asset.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "stream/source.h"

namespace deltamesh::gltf {

/// As triangle_corners(), of accessors that are in the store.
Result<std::vector<std::uint32_t>> read_corners(const AccessorStore& store, const PrimitiveSource& source);

/// Takes triangles out of `corners` that have two corners at one place whatever morph targets and joints do;
/// none where there would be no others. Returns how many.
std::size_t drop_degenerate(const AccessorStore& store, const PrimitiveSource& source,
                            std::vector<std::uint32_t>& corners);

}  // namespace deltamesh::gltf
