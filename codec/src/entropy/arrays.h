// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Arrays of numbers as byte planes, what the plain form of every chunk consists of: the lowest bytes of all
// numbers first, then the next lowest, and so on, so that zstd sees like beside like [CON-5].
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/byte_reader.h"
#include "base/byte_writer.h"

namespace deltamesh {

/// Writes one byte (how many planes: as few as the largest number needs), then the planes, numbers.size()
/// bytes each; nothing for no numbers.
void write_array(ByteWriter& out, std::span<const std::uint32_t> numbers);

/// Reads `count` numbers that write_array() wrote. `count` is checked against the
/// bytes present before anything is allocated, except where zero planes say that all numbers are 0: the
/// caller has checked `count` against a limit. Errors: kTruncated [CON-1], kInvalidStream [CON-5].
Result<std::vector<std::uint32_t>> read_array(ByteReader& in, std::uint64_t count);

/// The same of numbers that are near the one before [CON-7]: an array of zigzag codes of differences modulo
/// 2^width; `width`: 8, 16, 32 or 64.
void write_differences(ByteWriter& out, std::span<const std::uint64_t> numbers, unsigned width);
Result<std::vector<std::uint64_t>> read_differences(ByteReader& in, std::uint64_t count, unsigned width);

/// The same of indices that mostly are new or were used lately [CON-8]: an array of what each is below the
/// largest before plus 1, modulo 2^32.
void write_indices(ByteWriter& out, std::span<const std::uint32_t> indices);
Result<std::vector<std::uint32_t>> read_indices(ByteReader& in, std::uint64_t count);

}  // namespace deltamesh
