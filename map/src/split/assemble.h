// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The mesh of a part, from the blocks in its cell.
#pragma once

#include <span>

#include "deltamesh/map/part.h"
#include "split/borders.h"
#include "split/stored_block.h"

namespace deltamesh {

/// Vertices of different blocks with the same position and attributes become one. `blocks`: at least one, by
/// cell; `border`: of the part. O(n) expected.
MapPart assemble(const PartKey& key, std::span<const StoredBlock* const> blocks,
                 std::span<const BorderPosition> border);

}  // namespace deltamesh
