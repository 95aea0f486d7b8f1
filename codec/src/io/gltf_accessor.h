// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Accessors that the importer needs: what it cannot read is an error.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "accessor.h"

namespace deltamesh {

/// Errors: kInvalidFile (malformed, a shape that core glTF does not have, matrices of padded columns).
Result<gltf::AccessorShape> needed_shape(const gltf::Document& document, std::size_t accessor);

/// The caller has bounded the accessor's count. Errors: kInvalidFile (the same; beyond its view or buffer, or
/// bytes that only an extension knows).
Result<gltf::AccessorRows> needed_rows(const gltf::Document& document, std::size_t accessor);

/// A SCALAR accessor of unsigned integers as vertex indices, each below `vertices`. Errors: kInvalidFile.
Result<std::vector<std::uint32_t>> read_indices(const gltf::Document& document, std::size_t accessor,
                                                std::uint64_t vertices);

}  // namespace deltamesh
