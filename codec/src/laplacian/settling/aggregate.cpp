// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/aggregate.h"

#include <vector>

namespace deltamesh::settling {
namespace {

/// A node with more neighbours than this many times the mean is a hub: a seed that is no average of what is
/// around it.
constexpr double kHubShare = 2;

/// Codes in the making. An anchor's is its place among the anchors, plus kSeed.
constexpr std::uint32_t kFree = ~std::uint32_t{0};
constexpr std::uint32_t kHub = kFree - 1;
constexpr std::uint32_t kAnchors = kFree - 2;  ///< belongs to an anchor that has no number yet

/// Of a level.
std::uint32_t most_neighbors(const Level& level) noexcept {
  return static_cast<std::uint32_t>(kHubShare * static_cast<double>(level.neighbors.size()) /
                                    level.node_count());
}

/// Gives the free neighbours of `node` a code, and lists them from `place` on, whose end it returns; what
/// comes next there may be overwritten. Written without a branch, which could not be predicted.
std::uint32_t* claim_neighbors(const Level& fine, std::uint32_t node, std::uint32_t code,
                               std::uint32_t* codes, std::uint32_t* place) noexcept {
  const std::uint32_t* const end = fine.neighbors.data() + fine.offsets[node + 1];
  for (const std::uint32_t* e = fine.neighbors.data() + fine.offsets[node]; e != end; ++e) {
    const std::uint32_t neighbor = *e;
    const std::uint32_t old = codes[neighbor];
    const bool is_free = old == kFree;
    codes[neighbor] = is_free ? code : old;
    *place = neighbor;
    place += is_free ? 1 : 0;
  }
  return place;
}

/// What belongs to anchors, one after the other.
struct AnchorNodes {
  std::vector<std::uint32_t> nodes;
  std::vector<std::size_t> start{0};

  std::span<const std::uint32_t> of(std::uint32_t anchor) const noexcept {
    return {nodes.data() + start[anchor], nodes.data() + start[anchor + 1]};
  }
};

/// Hubs, and anchors with what belongs to them.
AnchorNodes begin_codes(const Level& fine, std::uint32_t* codes) {
  const std::uint32_t most = most_neighbors(fine);
  const auto degree = [offsets = fine.offsets.data()](std::uint32_t node) {
    return offsets[node + 1] - offsets[node];
  };
  const std::uint32_t n = fine.node_count();
  for (std::uint32_t node = 0; node < n; ++node) codes[node] = degree(node) > most ? kHub : kFree;
  for (std::uint32_t a = 0; a < fine.anchors.size(); ++a) codes[fine.anchors[a]] = Aggregates::kSeed + a;
  AnchorNodes owned;
  for (const std::uint32_t anchor : fine.anchors) {
    if (degree(anchor) <= most) {
      owned.nodes.resize(owned.start.back() + degree(anchor));
      const std::uint32_t* const end =
          claim_neighbors(fine, anchor, kAnchors, codes, owned.nodes.data() + owned.start.back());
      owned.nodes.resize(static_cast<std::size_t>(end - owned.nodes.data()));
    }
    owned.start.push_back(owned.nodes.size());
  }
  return owned;
}

}  // namespace

Aggregates aggregate(const Level& fine) {
  const std::uint32_t n = fine.node_count();
  Aggregates result;
  result.codes.resize(n);
  result.members.resize(n + 1);
  std::uint32_t* const codes = result.codes.data();
  const AnchorNodes owned = begin_codes(fine, codes);
  std::uint32_t* const members = result.members.data();
  std::uint32_t* member = members;
  for (std::uint32_t node = 0; node < n; ++node) {
    const std::uint32_t code = codes[node];
    if (code < Aggregates::kSeed || code == kAnchors) continue;
    const auto number = static_cast<std::uint32_t>(result.start.size());
    result.start.push_back(static_cast<std::uint32_t>(member - members));
    codes[node] = Aggregates::kSeed + number;
    *member++ = node;
    if (code == kFree) {
      member = claim_neighbors(fine, node, number, codes, member);
    } else if (code != kHub) {
      for (const std::uint32_t other : owned.of(code - Aggregates::kSeed)) {
        codes[other] = number;
        *member++ = other;
      }
    }
  }
  result.start.push_back(n);
  result.members.resize(n);
  return result;
}

}  // namespace deltamesh::settling
