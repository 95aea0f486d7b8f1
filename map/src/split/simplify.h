// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Fewer triangles for a coarser copy of parts [MAP-19].
#pragma once

#include "deltamesh/map/part.h"

namespace deltamesh {

/// `part` with as few triangles, down to a quarter, as edge collapses within `max_error` (model units, above
/// 0) leave. Every vertex that stays is one of `part`, with its attributes; border vertices and vertices that
/// faces of several groups have all stay. An edge has an odd number of faces only where it had before, or
/// where edges that had became it: what was closed stays closed, and borders stay as they are. Source:
/// meshoptimizer's simplifier (Garland and Heckbert 1997). O(n log n). Throws std::bad_alloc.
MapPart simplify(const MapPart& part, double max_error);

}  // namespace deltamesh
