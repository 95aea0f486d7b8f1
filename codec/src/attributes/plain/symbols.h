// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// One component of an attribute as symbols below 2^width, in coding order: differences where they pay, then
// byte planes [ATTR-3].
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/byte_reader.h"
#include "base/byte_writer.h"

namespace deltamesh {

/// Bits of the prediction byte [ATTR-3].
enum : std::uint8_t {
  kPredictVertex = 1,     ///< the same component of the vertex before
  kPredictComponent = 2,  ///< the component before, of the same vertex
  kPredictions = 4,       ///< how many combinations
};

/// 2^width - 1; `width` 1 to 64.
constexpr std::uint64_t symbol_mask(unsigned width) noexcept { return ~std::uint64_t{0} >> (64 - width); }

/// A difference modulo 2^width as a number that is small when the difference is near zero on either side:
/// 0, -1, 1, -2, ... become 0, 1, 2, 3, ...
constexpr std::uint64_t fold_difference(std::uint64_t difference, unsigned width) noexcept {
  const std::uint64_t r = difference & symbol_mask(width);
  return (r >> (width - 1)) == 0 ? r << 1 : ((~r & symbol_mask(width)) << 1) | 1;
}

constexpr std::uint64_t unfold_difference(std::uint64_t code, unsigned width) noexcept {
  return ((code & 1) == 0 ? code >> 1 : ~(code >> 1)) & symbol_mask(width);
}

/// Writes the prediction byte and the planes, with the prediction whose residuals have the least order-0
/// entropy. `before`: the component before, or empty for the first. O(n).
void write_symbols(ByteWriter& out, std::span<const std::uint64_t> symbols,
                   std::span<const std::uint64_t> before, unsigned width);

/// Reads what write_symbols wrote; every symbol is below 2^width. `count` has been checked against a limit.
/// Errors: kTruncated, kInvalidStream [ATTR-3, CON-1, CON-5].
Result<std::vector<std::uint64_t>> read_symbols(ByteReader& in, std::uint64_t count,
                                                std::span<const std::uint64_t> before, unsigned width);

}  // namespace deltamesh
