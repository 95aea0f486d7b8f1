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

/// For every node the seed that it belongs to.
LargeVector<std::uint32_t> choose_seeds(const Level& fine) {
  LargeVector<std::uint32_t> seed(fine.node_count(), kNone);
  const std::uint32_t most = most_neighbors(fine);
  const auto is_hub = [&](std::uint32_t node) { return fine.offsets[node + 1] - fine.offsets[node] > most; };
  for (std::uint32_t node = 0; node < seed.size(); ++node) {
    if (is_hub(node)) seed[node] = node;
  }
  for (const std::uint32_t anchor : fine.anchors) seed[anchor] = anchor;
  const auto claim_neighbors = [&](std::uint32_t node) {
    for (std::uint32_t e = fine.offsets[node]; e < fine.offsets[node + 1]; ++e) {
      std::uint32_t& owner = seed[fine.neighbors[e]];
      owner = owner == kNone ? node : owner;
    }
  };
  for (const std::uint32_t anchor : fine.anchors) {
    if (!is_hub(anchor)) claim_neighbors(anchor);
  }
  for (std::uint32_t node = 0; node < seed.size(); ++node) {
    if (seed[node] != kNone) continue;
    seed[node] = node;
    claim_neighbors(node);
  }
  return seed;
}

}  // namespace

Aggregates aggregate(const Level& fine) {
  Aggregates aggregates;
  aggregates.codes = choose_seeds(fine);
  LargeVector<std::uint32_t> number(aggregates.codes.size());
  for (std::uint32_t node = 0; node < number.size(); ++node) {
    if (aggregates.codes[node] != node) continue;
    number[node] = static_cast<std::uint32_t>(aggregates.seeds.size());
    aggregates.seeds.push_back(node);
  }
  for (std::uint32_t node = 0; node < number.size(); ++node) {
    const std::uint32_t seed = aggregates.codes[node];
    aggregates.codes[node] = number[seed] + (seed == node ? Aggregates::kSeed : 0);
  }
  return aggregates;
}

}  // namespace deltamesh::multigrid
