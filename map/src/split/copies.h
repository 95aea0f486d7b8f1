// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Coarser copies of parts [MAP-19]: each of what is in a cell one level below, simplified.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "split/layout.h"

namespace deltamesh {

/// The coarser copy of a cell above parts.
struct Copy {
  std::uint64_t hash = 0;      ///< of what it was made from
  std::uint64_t revision = 0;  ///< of the map, when it became as it is
  StoredBlock block{};         ///< simplified
  std::vector<BorderPosition> border{};
  bool is_part = false;   ///< whether it is small enough to be a part
  bool is_newest = true;  ///< nothing below has changed since
  bool is_told = false;   ///< the newest one was told of
};

/// By key: those that were made.
using Copies = std::map<PartKey, Copy>;

struct OutdatedCopies {
  std::vector<PartKey> outdated;  ///< that were told of, and are not of what is below any more
  std::vector<PartKey> removed;   ///< with nothing below any more
};

/// The error that a copy is simplified with where that leaves few enough triangles, model units.
double simplification_error(const PartKey& cell, const MapDescription& description) noexcept;

/// Marks the copies above these parts as outdated. `touched`: of the layout's last changes. O(levels * log n)
/// for each.
OutdatedCopies outdate_copies(const std::set<PartKey>& touched, const Layout& layout, Copies& copies);

/// Makes coarser copies, each from those one level below, which are made before.
class CopyMaker {
 public:
  /// Simplifies until it has seen `most_triangles`, and one cell at the least.
  CopyMaker(const Layout& layout, const MapDescription& description, const SplitOptions& options,
            std::uint64_t revision, std::uint64_t most_triangles, Copies& copies)
      : layout_(layout),
        description_(description),
        options_(options),
        revision_(revision),
        most_triangles_(most_triangles),
        copies_(copies) {}

  /// The newest copy of a cell above parts, of levels 1 to options.copy_level; null: triangles are used up.
  /// Where nothing below has changed it stays. Takes a simplification of what is in its cell one level below.
  Copy* make(const PartKey& cell);

 private:
  const Layout& layout_;
  const MapDescription& description_;
  const SplitOptions& options_;
  std::uint64_t revision_;
  std::uint64_t most_triangles_;
  std::uint64_t seen_ = 0;
  Copies& copies_;
};

/// A copy that is a part. Precondition: is_part.
MapPart part_of(const PartKey& key, const Copy& copy);

}  // namespace deltamesh
