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
  std::uint64_t hash = 0;  ///< of what it was made from
  StoredBlock block{};     ///< simplified
  std::vector<BorderPosition> border{};
  bool is_part = false;  ///< whether it is small enough to be a part
};

/// By key.
using Copies = std::map<PartKey, Copy>;

struct CopyChange {
  std::set<PartKey> changed;  ///< new copies that are parts, and those that are not as before
  std::set<PartKey> removed;  ///< copies that were parts
};

/// Makes the coarser copies above these parts anew, on levels 1 to options.copy_level; those whose sources
/// have not changed stay. `touched`: of the layout's last changes. Cost per level: a simplification of what
/// is in their cells one level below.
CopyChange update_copies(const std::set<PartKey>& touched, const Layout& layout,
                         const MapDescription& description, const SplitOptions& options, Copies& copies);

/// A copy that is a part. Precondition: is_part.
MapPart part_of(const PartKey& key, const Copy& copy);

}  // namespace deltamesh
