// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Values that an attribute's coding cannot hold, kept one by one, so that all others keep their bound
// [ATTR-12].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "attributes/rows.h"
#include "base/byte_reader.h"
#include "base/byte_writer.h"
#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// Of the byte of a compact coding: exceptions follow.
inline constexpr std::uint8_t kExceptionsFlag = 0x80;

/// Vertices in a row that have the same value.
struct ExceptionRun {
  std::uint32_t begin = 0;
  std::uint32_t length = 0;  ///< 1 or more
  std::uint32_t row = 0;     ///< of Exceptions::rows
};

struct Exceptions {
  std::vector<std::byte> rows;     ///< the different values, one after the other
  std::vector<ExceptionRun> runs;  ///< ascending

  bool empty() const noexcept { return runs.empty(); }
};

/// Puts the exceptions into decoded `values` of `row_size` bytes for each vertex.
void put_exceptions(const Exceptions& exceptions, std::size_t row_size, std::span<std::byte> values) noexcept;

/// `count`: vertices. Errors: kTruncated, kInvalidStream [ATTR-12].
Result<Exceptions> read_exceptions(ByteReader& in, std::size_t row_size, std::uint32_t count);

void write_exceptions(ByteWriter& out, const Exceptions& exceptions, std::size_t row_size);

/// What no coding of the attribute's kind holds: values with a component that is not finite; tangents without
/// direction or side; weights that do not add up to 1; floating-point colours beyond 0 to 1; texture
/// coordinates so large that float32 has few digits left beside `bound`. Empty where there is none, or where
/// it is so much that the list does not pay.
Exceptions find_exceptions(const AttributeView& attribute, const AttributeRows& rows, double bound);

/// The rows in coded order, but those of exceptions are as a vertex before them, or else behind. Not for
/// exceptions that are all there is.
std::vector<std::byte> without_exceptions(const AttributeRows& rows, std::size_t row_size,
                                          const Exceptions& exceptions);

}  // namespace deltamesh
