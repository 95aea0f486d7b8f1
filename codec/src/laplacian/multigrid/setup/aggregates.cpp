// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid/setup/aggregates.h"

#include <vector>

namespace deltamesh::multigrid {
namespace {

/// Codes of nodes that belong to no seed yet.
constexpr std::uint32_t kFree = ~std::uint32_t{0};
constexpr std::uint32_t kNearFirst = kFree - 1;  ///< has one of the first seeds for a neighbour: no seed
constexpr std::uint32_t kFirst = kFree - 2;      ///< one of the first seeds

/// Of a node of the finest level that is no seed in any case.
constexpr std::uint32_t kMostNeighbors = 24;

/// Gives the neighbours of `node` that belong to no seed yet, and are none, to seed `number`; lists them from
/// `place` on, whose end it returns; what comes next there may be overwritten. Written without a branch,
/// which could not be predicted.
std::uint32_t* claim_neighbors(const Level& fine, std::uint32_t node, std::uint32_t number,
                               std::uint32_t* codes, std::uint32_t* place) noexcept {
  const std::uint32_t* const end = fine.neighbors.data() + fine.offsets[node + 1];
  for (const std::uint32_t* e = fine.neighbors.data() + fine.offsets[node]; e != end; ++e) {
    const std::uint32_t neighbor = *e;
    const std::uint32_t old = codes[neighbor];
    const bool is_unclaimed = old >= kNearFirst;
    codes[neighbor] = is_unclaimed ? number : old;
    *place = neighbor;
    place += is_unclaimed ? 1 : 0;
  }
  return place;
}

/// Anchors, and hubs: the mass of these is so large that what they are interpolated from would be wrong.
std::vector<std::uint32_t> first_seeds(const Level& fine) {
  std::vector<std::uint32_t> seeds = fine.anchors;
  if (!fine.weights.empty()) return seeds;
  for (std::uint32_t node = 0; node < fine.node_count(); ++node) {
    if (fine.offsets[node + 1] - fine.offsets[node] > kMostNeighbors) seeds.push_back(node);
  }
  return seeds;
}

void mark(std::span<const std::uint32_t> seeds, const Level& fine, std::uint32_t* codes) noexcept {
  for (const std::uint32_t seed : seeds) {
    for (std::uint32_t e = fine.offsets[seed]; e < fine.offsets[seed + 1]; ++e)
      codes[fine.neighbors[e]] = kNearFirst;
  }
  for (const std::uint32_t seed : seeds) codes[seed] = kFirst;
}

}  // namespace

Aggregates aggregate(const Level& fine) {
  const std::uint32_t n = fine.node_count();
  Aggregates result;
  result.codes.resize(n, kFree);
  result.members.resize(n + 1);
  std::uint32_t* const codes = result.codes.data();
  mark(first_seeds(fine), fine, codes);
  std::uint32_t* const members = result.members.data();
  std::uint32_t* member = members;
  for (std::uint32_t node = 0; node < n; ++node) {
    if (codes[node] != kFree && codes[node] != kFirst) continue;
    const auto number = static_cast<std::uint32_t>(result.start.size());
    result.start.push_back(static_cast<std::uint32_t>(member - members));
    codes[node] = Aggregates::kSeed + number;
    *member++ = node;
    member = claim_neighbors(fine, node, number, codes, member);
  }
  result.start.push_back(static_cast<std::uint32_t>(member - members));
  result.members.resize(result.start.back());
  return result;
}

}  // namespace deltamesh::multigrid
