// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which parts a receiver is to have next: coarser copies before what they are copies of [MAP-19].
#pragma once

#include <set>

#include "viewer_state.h"

namespace deltamesh {

struct WantedParts {
  std::set<PartKey> wanted;  ///< cells that do not overlap, and that hold all parts in the view
  std::set<PartKey> others;  ///< parts in the view besides
};

/// Of what is in the view, the coarsest where the receiver has nothing; where it has a coarser copy, or
/// something below it, what comes below that. In the end the parts in the view that hold no others.
/// O(n log n) for n parts.
WantedParts wanted_parts(const Viewer& viewer, const SourceMap& map, const MapDescription& description);

}  // namespace deltamesh
