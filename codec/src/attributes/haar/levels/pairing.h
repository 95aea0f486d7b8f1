// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which nodes of a level become one of the next [HAAR-4].
#pragma once

#include <cstdint>

#include "attributes/haar/levels/levels.h"
#include "base/memory/large_vector.h"

namespace deltamesh {

/// The node that each is joined with; itself where it stays alone. At least one pair where there are two
/// nodes. O(nodes and neighbours), and sorting the isolated nodes.
LargeVector<std::uint32_t> pair_nodes(const HaarLevel& level);

}  // namespace deltamesh
