// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// DELT and ANCH in the plain form: quantised deltas, and anchors with their cells [PLN-4].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/memory/large_vector.h"
#include "deltamesh/result.h"
#include "format/highpass_parameters.h"
#include "highpass/symbols.h"

namespace deltamesh {

/// `deltas`: x of all solved vertices, then y, then z.
std::vector<std::byte> write_plain_deltas(std::span<const std::int32_t> deltas);
/// The same. Errors: kTruncated, kInvalidStream.
Result<LargeVector<std::int32_t>> read_plain_deltas(std::span<const std::byte> payload, std::size_t vertices);

/// `anchors`: ascending; `cells`: theirs.
std::vector<std::byte> write_plain_anchors(std::span<const std::uint32_t> anchors,
                                           std::span<const AnchorCell> cells);
/// Sets the anchors of `symbols` and their cells. Errors: kTruncated, kInvalidStream [ANCH-3, ANCH-4].
Result<void> read_plain_anchors(std::span<const std::byte> payload, std::size_t vertices,
                                const HighpassParameters& parameters, HighpassSymbols& symbols);

}  // namespace deltamesh
