// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The compact form of an attribute's symbols: differences to the mean of the neighbours that are coded
// already, as fields of up to three components [ATTR-9].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/result.h"
#include "topology/adjacency.h"

namespace deltamesh {

/// Wider symbols have no compact form.
inline constexpr unsigned kWidestField = 24;

/// One column per component, n symbols each.
using FieldColumns = std::vector<std::vector<std::uint64_t>>;

/// How a stream's columns look.
struct FieldShape {
  std::size_t components;  ///< 1 to 16
  unsigned width;          ///< 1 to kWidestField; symbols are below 2^width
  bool is_color;           ///< of three components or more, the first three are coded as G, R - G, B - G
};

/// O(n + edges).
std::vector<std::byte> write_field_columns(const FieldColumns& columns, const Adjacency& graph,
                                           const FieldShape& shape);

/// Errors: kTruncated, kInvalidStream [CMP-3, FLD-1, ATTR-9].
Result<FieldColumns> read_field_columns(std::span<const std::byte> bytes, const Adjacency& graph,
                                        const FieldShape& shape);

}  // namespace deltamesh
