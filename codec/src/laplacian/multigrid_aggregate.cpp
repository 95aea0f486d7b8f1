// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid_aggregate.h"

namespace deltamesh::multigrid {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

enum class Role : std::uint8_t { kOpen, kSeed, kMember };

std::vector<Role> choose_seeds(const Level& fine) {
  std::vector<Role> role(fine.node_count(), Role::kOpen);
  const auto make_seed = [&](std::uint32_t node) {
    role[node] = Role::kSeed;
    for (std::uint32_t e = fine.offsets[node]; e < fine.offsets[node + 1]; ++e) {
      Role& neighbor = role[fine.neighbors[e]];
      if (neighbor == Role::kOpen) neighbor = Role::kMember;
    }
  };
  for (const std::uint32_t anchor : fine.anchors) make_seed(anchor);
  for (std::uint32_t node = 0; node < role.size(); ++node) {
    if (role[node] == Role::kOpen) make_seed(node);
  }
  return role;
}

}  // namespace

Aggregates aggregate(const Level& fine) {
  const std::vector<Role> role = choose_seeds(fine);
  Aggregates aggregates;
  aggregates.of.assign(role.size(), kNone);
  for (std::uint32_t node = 0; node < role.size(); ++node) {
    if (role[node] != Role::kSeed) continue;
    aggregates.of[node] = static_cast<std::uint32_t>(aggregates.seeds.size());
    aggregates.seeds.push_back(node);
  }
  std::vector<std::uint32_t> size(aggregates.seeds.size(), 1);
  for (std::uint32_t node = 0; node < role.size(); ++node) {
    if (role[node] == Role::kSeed) continue;
    std::uint32_t smallest = kNone;
    for (std::uint32_t e = fine.offsets[node]; e < fine.offsets[node + 1]; ++e) {
      if (role[fine.neighbors[e]] != Role::kSeed) continue;
      const std::uint32_t candidate = aggregates.of[fine.neighbors[e]];
      if (smallest == kNone || size[candidate] < size[smallest]) smallest = candidate;
    }
    aggregates.of[node] = smallest;
    ++size[smallest];
  }
  return aggregates;
}

}  // namespace deltamesh::multigrid
