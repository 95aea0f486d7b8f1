// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Byte planes: the lowest bytes of all symbols first, then the next lowest, and so on, so that a byte-wise
// entropy coder sees like beside like [CON-5].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/byte_reader.h"
#include "base/byte_writer.h"

namespace deltamesh {

/// Writes one byte (how many planes, 0 to 4: as few as the largest symbol needs), then the planes,
/// symbols.size() bytes each.
void write_planes(ByteWriter& out, std::span<const std::uint32_t> symbols);

/// Reads `count` symbols written by write_planes. `count` is checked against the bytes present before
/// anything is allocated, except where zero planes say that all symbols are 0: the caller has checked `count`
/// against a limit. Errors: kTruncated [CON-1], kInvalidStream [CON-5].
Result<std::vector<std::uint32_t>> read_planes(ByteReader& in, std::uint64_t count);

}  // namespace deltamesh
