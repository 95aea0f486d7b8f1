// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Values of a glTF accessor, every range checked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "io/gltf_document.h"

namespace deltamesh {

using GltfBuffers = std::span<const std::span<const std::byte>>;

/// Accessor `index`. Errors: kInvalidFile where there is none.
Result<const GltfAccessor*> find_accessor(const GltfDocument& document, int index);

/// count x components values, tightly packed, native byte order; strides, missing buffer views (zeros) and
/// sparse values are dealt with. The caller has bounded `accessor.count`. Errors: kInvalidFile: a range
/// outside its buffer view or buffer, a sparse index outside the accessor, a matrix of padded columns.
Result<std::vector<std::byte>> read_accessor(const GltfDocument& document, GltfBuffers buffers,
                                             const GltfAccessor& accessor);

/// A SCALAR accessor of unsigned integers as vertex indices, each below `vertices`. Errors: kInvalidFile.
Result<std::vector<std::uint32_t>> read_indices(const GltfDocument& document, GltfBuffers buffers,
                                                const GltfAccessor& accessor, std::uint64_t vertices);

}  // namespace deltamesh
