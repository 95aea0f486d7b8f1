// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// All parts of a map, as its blocks make them.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "deltamesh/map/description.h"
#include "deltamesh/map/part.h"
#include "deltamesh/map/split.h"
#include "split/borders.h"
#include "split/octree.h"
#include "split/stored_block.h"

namespace deltamesh {

struct LayoutChange {
  std::set<PartKey> changed;  ///< new parts, and those whose mesh or border is not as before
  std::set<PartKey> removed;
  std::set<PartKey> touched;                    ///< all these, and parts that have a changed border position
  std::set<std::pair<PartKey, PartKey>> pairs;  ///< that have other positions in common; lower keys first
};

class Layout {
 public:
  Layout(const MapDescription& description, const SplitOptions& options)
      : lattice_(description.lattice),
        size_{options.most_triangles, options.most_level},
        borders_(lattice_) {}

  /// Puts blocks in the place of those with their cells; without triangles: removes them. Blocks with the
  /// same hash stay. O(n log n) for the vertices of the blocks and of the parts that they change.
  LayoutChange update(StoredBlocks blocks);

  const std::set<PartKey>& parts() const noexcept { return parts_; }
  MapPart part(const PartKey& key) const;
  /// Whether the cell holds parts of lower levels.
  bool is_above_parts(const PartKey& cell) const;
  /// By cell.
  std::vector<const StoredBlock*> blocks_in(const PartKey& key) const;
  /// The positions in a cell that parts outside of it have too, ascending.
  std::vector<BorderPosition> border_of(const PartKey& cell) const;

 private:
  void leave_out_known(StoredBlocks& blocks) const;
  std::set<PartKey> parts_before(const StoredBlocks& blocks) const;
  std::set<Cell0> cells_of(const std::set<PartKey>& parts, const StoredBlocks& blocks) const;
  void replace(StoredBlocks&& blocks);

  MapLattice lattice_;
  PartSize size_;
  std::map<Cell0, PlacedBlock> blocks_;
  Octree octree_;
  std::set<PartKey> parts_;
  Borders borders_;
};

}  // namespace deltamesh
