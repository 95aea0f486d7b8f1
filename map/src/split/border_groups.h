// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Groups the changed parts of a map that must be shown together [MAP-9].
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "deltamesh/map/part_key.h"
#include "split/layout.h"

namespace deltamesh {

struct KnownPart {
  PartKey key{};
  std::uint64_t hash = 0;
};

/// By two keys, the lower one first: a hash of what their parts have in common; pairs that have nothing are
/// not there.
using SharedBorders = std::map<std::pair<PartKey, PartKey>, std::uint64_t>;
SharedBorders shared_borders(const Layout& layout);

struct PartDifference {
  std::set<PartKey> changed;  ///< new ones, and those whose hash differs
  std::set<PartKey> removed;
};
/// Both ascending by key.
PartDifference compare_parts(const std::vector<KnownPart>& before, const std::vector<KnownPart>& after);

struct GroupNumbers {
  std::map<PartKey, std::uint64_t> numbers;  ///< of all parts that changed or went
  std::uint64_t next = 0;
};
/// Two parts of the difference are in one group where their common border is not as before, or where their
/// cells overlap. Groups are numbered from `next` on, by their first keys.
GroupNumbers group_changes(const PartDifference& difference, const SharedBorders& before,
                           const SharedBorders& after, std::uint64_t next);

}  // namespace deltamesh
