// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/haar/levels/levels.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "attributes/haar/levels/pairing.h"
#include "base/small_code.h"

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
  LargeVector<std::uint32_t> all(fine.graph.neighbors.size());
  LargeVector<std::uint32_t> last_seen_by(children.size(), HaarChildren::kNone);
  std::uint32_t end = 0;
  in_turns(static_cast<std::uint32_t>(children.size()),
           [&, last_seen_by = last_seen_by.data(), neighbors = all.data()](std::uint32_t first,
                                                                           std::uint32_t last) {
             std::uint32_t next = end;
             for (std::uint32_t i = first; i < last; ++i) {
               graph.offsets[i] = next;
               last_seen_by[i] = i;
               for (const std::uint32_t child : {children[i].first, children[i].second}) {
                 if (child == HaarChildren::kNone) break;
                 for (const std::uint32_t neighbor : fine.graph.of(child)) {
                   const std::uint32_t j = parents[neighbor];
                   // Overwritten where it was there already: a branch would often go wrong.
                   neighbors[next] = j;
                   next += last_seen_by[j] != i ? 1 : 0;
                   last_seen_by[j] = i;
                 }
               }
               next = std::min(next, graph.offsets[i] + kMostHaarNeighbors);
             }
             end = next;
           });
  graph.offsets.back() = end;
  graph.neighbors.assign(all.begin(), all.begin() + end);
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
  in_turns(n, [&](std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t v = begin; v < end; ++v) {
      level.nodes[v] = {.place = places[v], .weight = 1};
      std::uint32_t room = kMostHaarNeighbors;
      const auto add = [&](std::span<const std::uint32_t> more) {
        more = more.first(std::min<std::size_t>(more.size(), room));
        room -= static_cast<std::uint32_t>(more.size());
        level.graph.neighbors.insert(level.graph.neighbors.end(), more.begin(), more.end());
      };
      const auto is_copy = [&](std::uint32_t u) {
        return surface.geometric_of(u) == surface.geometric_of(v);
      };
      if (v > 0 && is_copy(v - 1)) add(std::array{v - 1});
      if (v + 1 < n && is_copy(v + 1)) add(std::array{v + 1});
      add(graph.of(v));
      level.graph.offsets[v + 1] = static_cast<std::uint32_t>(level.graph.neighbors.size());
    }
  });
  return level;
}

HaarLevel next_haar_level(const HaarLevel& fine, const LargeVector<std::uint32_t>& mates) {
  // Of every node the first child, and the parents of all.
  LargeVector<std::uint32_t> firsts(mates.size());
  LargeVector<std::uint32_t> parents(mates.size());
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < mates.size(); ++i) {
    firsts[count] = i;
    parents[i] = count;
    parents[i] = parents[std::min(i, mates[i])];
    count += mates[i] >= i ? 1 : 0;
  }
  HaarLevel level;
  level.nodes.resize(count);
  level.children.resize(count);
  for (std::uint32_t parent = 0; parent < count; ++parent) {
    const std::uint32_t i = firsts[parent];
    const HaarNode& node = fine.nodes[i];
    if (mates[i] == i) {
      level.children[parent] = {.first = i, .second = HaarChildren::kNone, .share_of_first = 0};
      level.nodes[parent] = node;
      continue;
    }
    const HaarNode& other = fine.nodes[mates[i]];
    const auto share = static_cast<std::uint32_t>((std::uint64_t{node.weight} << 16) /
                                                  (std::uint64_t{node.weight} + other.weight));
    level.children[parent] = {.first = i, .second = mates[i], .share_of_first = share};
    level.nodes[parent] = join_nodes(node, other, share);
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
