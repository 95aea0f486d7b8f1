// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Codings that have a plain form only, for zstd: bits of values, and levels of normals, colours and texture
// coordinates [ATTR-3 to ATTR-7].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "attributes/payload.h"
#include "attributes/rows.h"
#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// The payload, coding included, of the fewest bits that keep `bound` (AttributeInfo::error); exact where
/// that is 0 or no coding of the kind keeps it. O(n) for each number of bits tried.
std::vector<std::byte> write_plain_attribute(const AttributeView& attribute, const AttributeRows& rows,
                                             double bound);

/// The same, exact.
std::vector<std::byte> write_exact_attribute(const AttributeView& attribute, const AttributeRows& rows);

/// The values of a payload, coding included, which fits `shape`, whose own are not looked at. `rows`:
/// vertices, checked against a limit. Errors: kTruncated, kInvalidStream [ATTR-2, ATTR-3, ATTR-5, ATTR-7].
Result<std::vector<std::byte>> read_plain_values(std::span<const std::byte> payload, const Attribute& shape,
                                                 std::uint32_t rows);

}  // namespace deltamesh
