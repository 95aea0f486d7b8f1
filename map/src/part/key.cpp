// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <set>

#include "deltamesh/map/part_key.h"

namespace deltamesh {

std::vector<PartKey> keys_on_level(std::span<const PartKey> keys, std::uint8_t level) {
  std::vector<PartKey> shown;
  if (keys.empty()) return shown;
  const std::uint8_t highest = keys.back().level;
  std::set<PartKey> holders;  // cells above parts that are taken
  for (const PartKey& key : keys) {
    if (key.level < level || holders.contains(key)) continue;
    shown.push_back(key);
    for (int above = key.level + 1; above <= highest; ++above)
      holders.insert(ancestor(key, static_cast<std::uint8_t>(above)));
  }
  return shown;
}

std::uint8_t top_level(std::span<const PartKey> keys) {
  if (keys.empty()) return 0;
  const std::uint8_t highest = keys.back().level;
  std::uint8_t top = highest;
  for (const PartKey& key : keys_on_level(keys, 0)) {
    std::uint8_t level = highest;
    while (level > key.level && !std::binary_search(keys.begin(), keys.end(), ancestor(key, level))) --level;
    top = std::min(top, level);
  }
  return top;
}

}  // namespace deltamesh
