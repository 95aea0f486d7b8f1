// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// ATTR in the plain form: every component as whole numbers of steps, or as the bits of its values [PLN-6,
// PLN-7].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "attributes/rows.h"
#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// The first byte of a payload.
enum class PlainCoding : std::uint8_t {
  kNumbers = 0,     ///< components are what they are
  kDirections = 1,  ///< f32, 3 components or more, of which the first three are made a vector of length 1
};

inline constexpr std::int64_t kLargestPlainFirst = std::int64_t{1} << 52;  ///< either sign

/// The lattice of one component [PLN-6].
struct PlainSteps {
  double step = 0;         ///< finite, 0 or above; with 0 numbers are the bits of values
  std::int64_t first = 0;  ///< that number 0 stands for, in steps; at most kLargestPlainFirst in size

  bool is_exact() const noexcept { return step == 0; }
  /// One rounding, or none where 0 is meant.
  double at(std::uint64_t number) const noexcept {
    return step * static_cast<double>(first + static_cast<std::int64_t>(number));
  }
};

/// The payload whose values are within `bound` (AttributeInfo::error); exact where that is 0, no lattice
/// keeps it, or the kind has none (joints, weights). O(n).
std::vector<std::byte> write_plain_attribute(const AttributeView& attribute, const AttributeRows& rows,
                                             double bound);

/// The values of a payload for `shape`, whose own are not looked at. `rows`: vertices, checked against a
/// limit. Errors: kTruncated, kInvalidStream [PLN-6, PLN-7].
Result<std::vector<std::byte>> read_plain_values(std::span<const std::byte> payload, const Attribute& shape,
                                                 std::uint32_t rows);

}  // namespace deltamesh
