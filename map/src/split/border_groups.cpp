// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "split/border_groups.h"

#include <xxhash.h>

#include <algorithm>

#include "base/union_find.h"

namespace deltamesh {
namespace {

std::uint64_t hash_of_use(const BorderUse& use) {
  const std::array<std::uint32_t, 4> bits{use.position[0], use.position[1], use.position[2], use.twin};
  return XXH3_64bits(bits.data(), sizeof bits);
}

}  // namespace

SharedBorders shared_borders(const Layout& layout) {
  SharedBorders borders;
  const auto& uses = layout.uses;
  for (auto first = uses.begin(); first != uses.end();) {
    const auto last = std::find_if(first, uses.end(),
                                   [&](const BorderUse& use) { return use.position != first->position; });
    const std::uint64_t hash = hash_of_use(*first);
    for (auto a = first; a != last; ++a)
      for (auto b = a + 1; b != last; ++b)  // parts ascend by key
        borders[{layout.parts[a->part].key, layout.parts[b->part].key}] += hash;
    first = last;
  }
  return borders;
}

PartDifference compare_parts(const std::vector<KnownPart>& before, const std::vector<KnownPart>& after) {
  PartDifference difference;
  auto old = before.begin();
  for (const KnownPart& part : after) {
    for (; old != before.end() && old->key < part.key; ++old) difference.removed.insert(old->key);
    const bool is_known = old != before.end() && old->key == part.key;
    if (!is_known || old->hash != part.hash) difference.changed.insert(part.key);
    if (is_known) ++old;
  }
  for (; old != before.end(); ++old) difference.removed.insert(old->key);
  return difference;
}

GroupNumbers group_changes(const PartDifference& difference, const SharedBorders& before,
                           const SharedBorders& after, std::uint64_t next) {
  std::vector<PartKey> keys(difference.changed.begin(), difference.changed.end());
  keys.insert(keys.end(), difference.removed.begin(), difference.removed.end());
  std::ranges::sort(keys);
  UnionFind sets(keys.size());
  const auto place = [&](const PartKey& key) {
    const auto found = std::ranges::lower_bound(keys, key);
    return found != keys.end() && *found == key ? static_cast<std::size_t>(found - keys.begin())
                                                : keys.size();
  };
  const auto unite_pairs = [&](const SharedBorders& some, const SharedBorders& others) {
    for (const auto& [pair, hash] : some) {
      const auto other = others.find(pair);
      if (other != others.end() && other->second == hash) continue;
      const std::size_t a = place(pair.first);
      const std::size_t b = place(pair.second);
      if (a < keys.size() && b < keys.size()) sets.unite(a, b);
    }
  };
  unite_pairs(before, after);
  unite_pairs(after, before);
  for (const PartKey& key : difference.removed)
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
