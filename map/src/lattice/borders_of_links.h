// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The borders that a part's links name [MAP-12].
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "deltamesh/map/part_entry.h"

namespace deltamesh {

/// The border with the part `key`; 0 without a link to it. `links`: ascending by key. O(log n).
inline std::uint32_t border_in(const std::vector<PartLink>& links, const PartKey& key) noexcept {
  const auto found = std::ranges::lower_bound(links, key, {}, &PartLink::key);
  return found != links.end() && found->key == key ? found->border : 0;
}

/// Whether both have the same borders with the same parts. O(n).
inline bool same_borders(const std::vector<PartLink>& a, const std::vector<PartLink>& b) noexcept {
  return std::ranges::equal(
      a, b, [](const PartLink& x, const PartLink& y) { return x.key == y.key && x.border == y.border; });
}

}  // namespace deltamesh
