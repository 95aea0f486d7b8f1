// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// P of a level, from its edges and aggregates.
#pragma once

#include "base/large_vector.h"
#include "laplacian/settling/aggregate.h"
#include "laplacian/settling/level.h"

namespace deltamesh::settling {

/// Seeds keep their value. Another node's weights are its edge weights summed by the neighbours' aggregates,
/// seeds counted four times; the three largest, scaled to add up to 1. O(n + edges).
LargeVector<Interpolation> make_interpolation(const Level& fine, const Aggregates& aggregates);

}  // namespace deltamesh::settling
