// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid/setup/aggregates.h"

namespace deltamesh::multigrid {
namespace {

/// Codes of nodes that belong to no seed yet.
constexpr std::uint32_t kFree = Aggregates::kNone;
constexpr std::uint32_t kNearAnchor = kFree - 1;  ///< has an anchor for a neighbour: no seed
constexpr std::uint32_t kAnchor = kFree - 2;

/// Gives the neighbours of `node` that belong to no seed yet, and are none, to seed `number`; lists them from
/// `place` on, whose end it returns; what comes next there may be overwritten. Written without a branch,
/// which could not be predicted.
std::uint32_t* claim_neighbors(const Level& fine, std::uint32_t node, std::uint32_t number,
                               std::uint32_t* codes, std::uint32_t* place) noexcept {
  const std::uint32_t* const end = fine.neighbors.data() + fine.offsets[node + 1];
  for (const std::uint32_t* e = fine.neighbors.data() + fine.offsets[node]; e != end; ++e) {
    const std::uint32_t neighbor = *e;
    const std::uint32_t old = codes[neighbor];
    const bool is_unclaimed = old >= kNearAnchor;
    codes[neighbor] = is_unclaimed ? number : old;
    *place = neighbor;
    place += is_unclaimed ? 1 : 0;
  }
  return place;
}

void mark_anchors(const Level& fine, std::uint32_t* codes) noexcept {
  for (const std::uint32_t anchor : fine.anchors) {
    for (std::uint32_t e = fine.offsets[anchor]; e < fine.offsets[anchor + 1]; ++e)
      codes[fine.neighbors[e]] = kNearAnchor;
  }
  for (const std::uint32_t anchor : fine.anchors) codes[anchor] = kAnchor;
}

}  // namespace

Aggregates aggregate(const Level& fine) {
  const std::uint32_t n = fine.node_count();
  Aggregates result;
  result.codes.resize(n, kFree);
  result.members.resize(n + 1);
  std::uint32_t* const codes = result.codes.data();
  mark_anchors(fine, codes);
  std::uint32_t* const members = result.members.data();
  std::uint32_t* member = members;
  for (std::uint32_t node = 0; node < n; ++node) {
    if (codes[node] != kFree && codes[node] != kAnchor) continue;
    if (fine.offsets[node] == fine.offsets[node + 1]) {
      codes[node] = Aggregates::kNone;
      continue;
    }
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
