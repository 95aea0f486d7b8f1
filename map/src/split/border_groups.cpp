// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "split/border_groups.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "base/union_find.h"

namespace deltamesh {
GroupNumbers group_changes(const std::set<PartKey>& changed, const std::set<PartKey>& removed,
                           const PartPairs& pairs, std::uint64_t next) {
  std::vector<PartKey> keys;
  std::ranges::set_union(changed, removed, std::back_inserter(keys));
  UnionFind sets(keys.size());
  const auto place = [&](const PartKey& key) {
    const auto found = std::ranges::lower_bound(keys, key);
    return found != keys.end() && *found == key ? static_cast<std::size_t>(found - keys.begin())
                                                : keys.size();
  };
  for (const auto& [first, second] : pairs) {
    const std::size_t a = place(first);
    const std::size_t b = place(second);
    if (a < keys.size() && b < keys.size()) sets.unite(a, b);
  }
  for (const PartKey& key : removed)
    for (std::size_t i = 0; i < keys.size(); ++i)
      if (overlap(key, keys[i])) sets.unite(place(key), i);

  GroupNumbers groups{.numbers = {}, .next = next};
  std::map<std::size_t, std::uint64_t> numbers;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const auto [number, is_new] = numbers.try_emplace(sets.find(i), groups.next);
    if (is_new) ++groups.next;
    groups.numbers[keys[i]] = number->second;
  }
  return groups;
}

}  // namespace deltamesh
