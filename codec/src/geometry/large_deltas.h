// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Deltas of large graphs: a field in two parts, each of which can be read without the other [FLD-9].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/result.h"
#include "geometry/delta_columns.h"
#include "topology/adjacency.h"

namespace deltamesh {

/// `deltas`: of all vertices of `graph`, at most 2^30 in size. O(n + edges).
std::vector<std::byte> write_large_deltas(const DeltaColumns<const std::int32_t>& deltas,
                                          const Adjacency& graph);

/// The same numbers back, the parts side by side where the calling thread has a team. Errors: kTruncated,
/// kInvalidStream [CMP-3, FLD-1, CON-1].
Result<void> read_large_deltas(std::span<const std::byte> payload, const Adjacency& graph,
                               const DeltaColumns<std::int32_t>& deltas);

}  // namespace deltamesh
