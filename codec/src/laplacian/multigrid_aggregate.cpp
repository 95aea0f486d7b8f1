// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid_aggregate.h"

namespace deltamesh::multigrid {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

/// A node with more neighbours than this many times the mean is a hub: a seed that is no average of what is
/// around it.
constexpr double kHubShare = 2;

/// Of a level.
std::uint32_t most_neighbors(const Level& level) noexcept {
  return static_cast<std::uint32_t>(kHubShare * static_cast<double>(level.neighbors.size()) /
                                    level.node_count());
}

enum class Role : std::uint8_t { kOpen, kSeed, kHub, kMember };

std::vector<Role> choose_seeds(const Level& fine) {
  std::vector<Role> role(fine.node_count(), Role::kOpen);
  const std::uint32_t most = most_neighbors(fine);
  const auto is_hub = [&](std::uint32_t node) { return fine.offsets[node + 1] - fine.offsets[node] > most; };
  const auto make_seed = [&](std::uint32_t node) {
    role[node] = is_hub(node) ? Role::kHub : Role::kSeed;
    if (role[node] == Role::kHub) return;
    for (std::uint32_t e = fine.offsets[node]; e < fine.offsets[node + 1]; ++e) {
      Role& neighbor = role[fine.neighbors[e]];
      if (neighbor == Role::kOpen) neighbor = Role::kMember;
    }
  };
  for (const std::uint32_t anchor : fine.anchors) make_seed(anchor);
  for (std::uint32_t node = 0; node < role.size(); ++node) {
    if (is_hub(node)) role[node] = Role::kHub;
  }
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
    if (role[node] == Role::kMember) continue;
    aggregates.of[node] = static_cast<std::uint32_t>(aggregates.seeds.size());
    aggregates.seeds.push_back(node);
  }
  std::vector<std::uint32_t> size(aggregates.seeds.size(), 1);
  for (std::uint32_t node = 0; node < role.size(); ++node) {
    if (role[node] != Role::kMember) continue;
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
