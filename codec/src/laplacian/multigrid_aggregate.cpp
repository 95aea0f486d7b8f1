// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid_aggregate.h"

#include <vector>

namespace deltamesh::multigrid {
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
/// comes next there may be overwritten. No branch: it could not be predicted.
std::uint32_t* claim_neighbors(const Level& fine, std::uint32_t node, std::uint32_t code,
                               LargeVector<std::uint32_t>& codes, std::uint32_t* place) noexcept {
  for (std::uint32_t e = fine.offsets[node]; e < fine.offsets[node + 1]; ++e) {
    const std::uint32_t neighbor = fine.neighbors[e];
    const bool is_free = codes[neighbor] == kFree;
    codes[neighbor] = is_free ? code : codes[neighbor];
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
AnchorNodes begin_codes(const Level& fine, LargeVector<std::uint32_t>& codes) {
  const std::uint32_t most = most_neighbors(fine);
  const auto degree = [&](std::uint32_t node) { return fine.offsets[node + 1] - fine.offsets[node]; };
  for (std::uint32_t node = 0; node < codes.size(); ++node) codes[node] = degree(node) > most ? kHub : kFree;
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
  const AnchorNodes owned = begin_codes(fine, result.codes);
  std::uint32_t* member = result.members.data();
  const auto place = [&] { return static_cast<std::uint32_t>(member - result.members.data()); };
  for (std::uint32_t node = 0; node < n; ++node) {
    const std::uint32_t code = result.codes[node];
    if (code < Aggregates::kSeed || code == kAnchors) continue;
    const auto number = static_cast<std::uint32_t>(result.start.size());
    result.start.push_back(place());
    result.codes[node] = Aggregates::kSeed + number;
    *member++ = node;
    if (code == kFree) {
      member = claim_neighbors(fine, node, number, result.codes, member);
    } else if (code != kHub) {
      for (const std::uint32_t other : owned.of(code - Aggregates::kSeed)) {
        result.codes[other] = number;
        *member++ = other;
      }
    }
  }
  result.start.push_back(n);
  result.members.resize(n);
  return result;
}

}  // namespace deltamesh::multigrid
