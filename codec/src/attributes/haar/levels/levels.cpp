// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/haar/levels/levels.h"

#include <cstddef>
#include <utility>

#include "attributes/haar/levels/pairing.h"

namespace deltamesh {
namespace {

HaarNode join_nodes(const HaarNode& a, const HaarNode& b, std::uint32_t share_of_a) noexcept {
  HaarNode joined{.place = b.place, .weight = a.weight + b.weight};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t way = std::int64_t{a.place[axis]} - b.place[axis];
    joined.place[axis] += static_cast<std::int32_t>((way * share_of_a) >> 16);
  }
  return joined;
}

/// Neighbours of the children become neighbours, those of the first child first, each once.
Adjacency join_graph(const HaarLevel& fine, const LargeVector<HaarChildren>& children,
                     const LargeVector<std::uint32_t>& parents) {
  Adjacency graph;
  graph.offsets.resize(children.size() + 1);
  graph.neighbors.reserve(fine.graph.neighbors.size());
  graph.offsets[0] = 0;
  LargeVector<std::uint32_t> last_seen_by(children.size(), HaarChildren::kNone);
  for (std::uint32_t i = 0; i < children.size(); ++i) {
    last_seen_by[i] = i;
    std::uint32_t room = kMostHaarNeighbors;
    for (const std::uint32_t child : {children[i].first, children[i].second}) {
      if (child == HaarChildren::kNone) break;
      for (const std::uint32_t neighbor : fine.graph.of(child)) {
        const std::uint32_t j = parents[neighbor];
        if (last_seen_by[j] == i || room == 0) continue;
        last_seen_by[j] = i;
        graph.neighbors.push_back(j);
        --room;
      }
    }
    graph.offsets[i + 1] = static_cast<std::uint32_t>(graph.neighbors.size());
  }
  return graph;
}

}  // namespace

HaarLevel first_haar_level(const AttributeSurface& surface) {
  HaarLevel level;
  const std::uint32_t n = surface.vertex_count();
  const auto places = make_haar_places(surface.positions(), n);
  level.nodes.resize(n);
  const Adjacency& graph = surface.graph();
  level.graph.offsets.resize(std::size_t{n} + 1);
  level.graph.neighbors.reserve(graph.neighbors.size());
  level.graph.offsets[0] = 0;
  for (std::uint32_t v = 0; v < n; ++v) {
    level.nodes[v] = {.place = places[v], .weight = 1};
    const auto add = [&](std::uint32_t u) {
      if (level.graph.neighbors.size() - level.graph.offsets[v] < kMostHaarNeighbors)
        level.graph.neighbors.push_back(u);
    };
    const auto is_copy = [&](std::uint32_t u) { return surface.geometric_of(u) == surface.geometric_of(v); };
    if (v > 0 && is_copy(v - 1)) add(v - 1);
    if (v + 1 < n && is_copy(v + 1)) add(v + 1);
    for (const std::uint32_t u : graph.of(v)) add(u);
    level.graph.offsets[v + 1] = static_cast<std::uint32_t>(level.graph.neighbors.size());
  }
  return level;
}

HaarLevel next_haar_level(const HaarLevel& fine, const LargeVector<std::uint32_t>& mates) {
  HaarLevel level;
  LargeVector<std::uint32_t> parents(mates.size());
  level.nodes.reserve(mates.size());
  level.children.reserve(mates.size());
  for (std::uint32_t i = 0; i < mates.size(); ++i) {
    const std::uint32_t mate = mates[i];
    if (mate < i) continue;
    parents[i] = static_cast<std::uint32_t>(level.nodes.size());
    parents[mate] = parents[i];
    const HaarNode& node = fine.nodes[i];
    if (mate == i) {
      level.children.push_back({.first = i, .second = HaarChildren::kNone, .share_of_first = 0});
      level.nodes.push_back(node);
      continue;
    }
    const HaarNode& other = fine.nodes[mate];
    const auto share = static_cast<std::uint32_t>((std::uint64_t{node.weight} << 16) /
                                                  (std::uint64_t{node.weight} + other.weight));
    level.children.push_back({.first = i, .second = mate, .share_of_first = share});
    level.nodes.push_back(join_nodes(node, other, share));
  }
  level.graph = join_graph(fine, level.children, parents);
  return level;
}

std::vector<HaarLevel> make_haar_levels(const AttributeSurface& surface) {
  std::vector<HaarLevel> levels;
  levels.push_back(first_haar_level(surface));
  while (levels.back().nodes.size() > 1)
    levels.push_back(next_haar_level(levels.back(), pair_nodes(levels.back())));
  return levels;
}

}  // namespace deltamesh
