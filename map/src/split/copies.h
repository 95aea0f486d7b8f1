// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Coarser copies of parts [MAP-19]: each of what is in a cell one level below, simplified.
#pragma once

#include <cstdint>
#include <map>
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

/// Makes the coarser copies of the layout's parts, on levels 1 to options.copy_level. A copy is taken from
/// `known` if its sources have not changed. Cost per level: a simplification of the level below.
Copies make_copies(const Layout& layout, const MapDescription& description, const SplitOptions& options,
                   const Copies& known);

/// A copy that is a part. Precondition: is_part.
MapPart part_of(const PartKey& key, const Copy& copy);

}  // namespace deltamesh
