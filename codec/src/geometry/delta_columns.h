// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Deltas in memory, for their readers and writers.
#pragma once

#include <cstddef>
#include <cstdint>

#include "deltamesh/result.h"
#include "field/field_coder.h"
#include "format/tags.h"

namespace deltamesh {

/// x of all vertices, then y, then z.
template <class Number>
struct DeltaColumns {
  Number* values;
  std::size_t rows;

  FieldNumbers at(std::uint32_t v) const noexcept {
    return {values[v], values[rows + v], values[2 * rows + v]};
  }
  void put(std::uint32_t v, const FieldNumbers& q) const noexcept {
    for (std::size_t axis = 0; axis < 3; ++axis) values[axis * rows + v] = q[axis];
  }
};

inline Error delta_beyond_range() noexcept {
  return {.code = ErrorCode::kInvalidStream,
          .message = "a delta beyond 2^30 steps",
          .rule = "FLD-1",
          .chunk_tag = kTagDeltas};
}

}  // namespace deltamesh
