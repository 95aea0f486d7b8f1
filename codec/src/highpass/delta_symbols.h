// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The compact form of DELT: quantised deltas as a field on the graph [DELT-5].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/memory/large_vector.h"
#include "deltamesh/result.h"
#include "topology/adjacency.h"

namespace deltamesh {

/// `deltas`: x of all n vertices of `graph`, then y, then z, at most 2^30 in size. O(n + edges).
std::vector<std::byte> write_compact_deltas(std::span<const std::int32_t> deltas, const Adjacency& graph);

/// The same numbers back. Errors: kTruncated, kInvalidStream [CMP-3, FLD-1].
Result<LargeVector<std::int32_t>> read_compact_deltas(std::span<const std::byte> payload,
                                                      const Adjacency& graph);

}  // namespace deltamesh
