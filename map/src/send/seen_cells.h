// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Cells of all levels that hold something of the map in a viewer's view, and those in which it has something.
#pragma once

#include <set>

#include "send/viewer_state.h"

namespace deltamesh {

/// Of a moment: what is sent to the viewer, and other views, change it; copies that are made do not.
class SeenCells {
 public:
  /// O(n log n) for all parts and what the viewer has.
  SeenCells(const Viewer& viewer, const SourceMap& map, const MapDescription& description);

  /// Whether a cell holds something in the view: of a part there it is the cell on the view's level, or the
  /// part's own if that is higher, or one above. A copy of another cell shows nothing of the view.
  bool is_seen(const PartKey& cell) const { return seen_.contains(cell); }
  /// Whether the viewer has a part of this key, on the level of its view or above.
  bool has(const PartKey& key) const { return has_.contains(key); }
  /// Whether it has such a part in the cell or around it.
  bool is_begun(const PartKey& cell) const;

 private:
  std::set<PartKey> seen_;
  std::set<PartKey> has_;
  std::set<PartKey> above_;  ///< what it has, and all cells around that
};

}  // namespace deltamesh
