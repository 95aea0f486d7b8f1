// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid_groups.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "laplacian/multigrid_hierarchy.h"

namespace deltamesh::multigrid {
namespace {

/// Components up to this size are factored: cheaper than iterating, and nothing to go wrong.
constexpr std::uint32_t kLargestDirect = 64;

/// Around a vertex of higher degree an aggregate is no local average any more and cycles may settle on
/// nothing; such a component is factored up to this size.
constexpr std::uint32_t kLargestDegree = 64;
constexpr std::uint32_t kLargestDirectWithHub = 100000;

/// The subgraph of the vertices whose component has `wanted` in `key`.
Group extract(const Adjacency& graph, const Components& components, std::span<const std::uint32_t> anchors,
              std::span<const std::uint32_t> key, std::uint32_t wanted) {
  Group group;
  group.depth = wanted;
  std::vector<std::uint32_t> row(graph.vertex_count(), 0);
  for (std::uint32_t v = 0; v < graph.vertex_count(); ++v) {
    if (key[components.label[v]] != wanted) continue;
    row[v] = static_cast<std::uint32_t>(group.vertices.size());
    group.vertices.push_back(v);
  }
  group.graph.offsets.reserve(group.vertices.size() + 1);
  group.graph.offsets.push_back(0);
  for (const std::uint32_t v : group.vertices) {
    for (const std::uint32_t neighbor : graph.of(v)) group.graph.neighbors.push_back(row[neighbor]);
    group.graph.offsets.push_back(static_cast<std::uint32_t>(group.graph.neighbors.size()));
  }
  for (std::uint32_t a = 0; a < anchors.size(); ++a) {
    if (key[components.label[anchors[a]]] != wanted) continue;
    group.anchors.push_back(row[anchors[a]]);
    group.anchor_of.push_back(a);
  }
  group.components = find_components(group.graph);
  return group;
}

/// The graph as it is.
Group whole(const Adjacency& graph, const Components& components, std::span<const std::uint32_t> anchors,
            std::uint32_t depth) {
  Group group{.depth = depth,
              .vertices = std::vector<std::uint32_t>(graph.vertex_count()),
              .anchors = {anchors.begin(), anchors.end()},
              .anchor_of = std::vector<std::uint32_t>(anchors.size()),
              .graph = graph,
              .components = components};
  std::iota(group.vertices.begin(), group.vertices.end(), 0U);
  std::iota(group.anchor_of.begin(), group.anchor_of.end(), 0U);
  return group;
}

}  // namespace

std::vector<Group> group_components(const Adjacency& graph, std::span<const std::uint32_t> anchors) {
  const Components components = find_components(graph);
  std::vector<std::uint32_t> anchor_count(components.count, 0);
  for (const std::uint32_t anchor : anchors) ++anchor_count[components.label[anchor]];
  std::vector<std::uint32_t> direct_limit(components.count, kLargestDirect);
  for (std::uint32_t v = 0; v < graph.vertex_count(); ++v) {
    if (graph.degree(v) > kLargestDegree) direct_limit[components.label[v]] = kLargestDirectWithHub;
  }
  std::vector<std::uint32_t> depth(components.count, 0);
  for (std::uint32_t c = 0; c < components.count; ++c) {
    if (components.size[c] > direct_limit[c])
      depth[c] = coarsening_depth(components.size[c], anchor_count[c]);
  }
  if (std::adjacent_find(depth.begin(), depth.end(), std::not_equal_to<>()) == depth.end() && !depth.empty())
    return {whole(graph, components, anchors, depth.front())};
  std::vector<std::uint32_t> depths = depth;
  std::sort(depths.begin(), depths.end());
  depths.erase(std::unique(depths.begin(), depths.end()), depths.end());
  std::vector<Group> groups;
  for (const std::uint32_t d : depths) groups.push_back(extract(graph, components, anchors, depth, d));
  return groups;
}

Group extract_components(const Group& group, std::span<const std::uint8_t> chosen) {
  std::vector<std::uint32_t> key(chosen.size());
  for (std::size_t c = 0; c < key.size(); ++c) key[c] = chosen[c] != 0 ? 0 : 1;
  return extract(group.graph, group.components, group.anchors, key, 0);
}

}  // namespace deltamesh::multigrid
