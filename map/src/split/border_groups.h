// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Groups the changed parts of a map that must be shown together [MAP-9].
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "deltamesh/map/part_key.h"

namespace deltamesh {

/// Pairs of parts, the lower key first.
using PartPairs = std::set<std::pair<PartKey, PartKey>>;

struct GroupNumbers {
  std::map<PartKey, std::uint64_t> numbers;  ///< of all parts that changed or went
  std::uint64_t next = 0;
};
/// Two parts of those that changed or went are in one group where their common border is not as before
/// (`pairs`), or where the cell of one that went overlaps the other's. Groups are numbered from `next` on, by
/// their first keys.
GroupNumbers group_changes(const std::set<PartKey>& changed, const std::set<PartKey>& removed,
                           const PartPairs& pairs, std::uint64_t next);

}  // namespace deltamesh
