// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which parts a viewer is to have: those of its level; first, where it has nothing, coarser copies.
#pragma once

#include <set>

#include "send/seen_cells.h"
#include "send/viewer_state.h"

namespace deltamesh {

struct WantedParts {
  std::set<PartKey> wanted;  ///< cells that do not overlap, and that hold all parts of the map in the view
  std::set<PartKey> others;  ///< parts in the view besides
};

/// While copies that it is to see first are still to be made (`viewer.waits_for_copies`), nothing is wanted
/// where they come, and those that it has stay. O(n log n) for all parts and what the viewer has.
WantedParts wanted_parts(const Viewer& viewer, const SourceMap& map, const MapDescription& description,
                         const SeenCells& seen);

/// Makes what a viewer needs of coarser copies, or some of it. False: some are still to be made. Takes a few
/// dozen milliseconds at the most, or what the simplification of one cell takes.
Result<bool> make_copies_for(const Viewer& viewer, SourceMap& map, const MapDescription& description,
                             const SeenCells& seen);

}  // namespace deltamesh
