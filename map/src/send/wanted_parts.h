// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Chooses the parts that a receiver is to have next: coarser copies first [MAP-19].
#pragma once

#include <set>

#include "send/viewer_state.h"

namespace deltamesh {

struct WantedParts {
  std::set<PartKey> wanted;  ///< cells that do not overlap, and that hold all parts in the view
  std::set<PartKey> others;  ///< parts in the view besides
};

/// For the cells in the view: the coarsest copy if the receiver has nothing there; if it has a copy, or parts
/// below it, the next finer ones. In the end these are the parts in the view that contain no others. O(n log
/// n) for n parts.
WantedParts wanted_parts(const Viewer& viewer, const SourceMap& map, const MapDescription& description);

}  // namespace deltamesh
