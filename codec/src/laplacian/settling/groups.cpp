// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/groups.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "laplacian/settling/hierarchy.h"
#include "laplacian/settling/small_components.h"

namespace deltamesh::settling {
namespace {

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
  group.storage = std::make_unique<Adjacency>();
  group.graph = group.storage.get();
  Adjacency& part = *group.storage;
  part.offsets.reserve(group.vertices.size() + 1);
  part.offsets.push_back(0);
  for (const std::uint32_t v : group.vertices) {
    for (const std::uint32_t neighbor : graph.of(v)) part.neighbors.push_back(row[neighbor]);
    part.offsets.push_back(static_cast<std::uint32_t>(part.neighbors.size()));
  }
  for (std::uint32_t a = 0; a < anchors.size(); ++a) {
    if (key[components.label[anchors[a]]] != wanted) continue;
    group.anchors.push_back(row[anchors[a]]);
    group.anchor_of.push_back(a);
  }
  group.components = find_components(part);
  return group;
}

/// Per component, the anchors with anchors only for neighbours. They need no coarse nodes around them.
std::vector<std::uint32_t> count_inner_anchors(const Adjacency& graph, const Components& components,
                                               std::span<const std::uint32_t> anchors) {
  std::vector<std::uint8_t> is_anchor(graph.vertex_count(), 0);
  for (const std::uint32_t anchor : anchors) is_anchor[anchor] = 1;
  std::vector<std::uint32_t> count(components.count, 0);
  for (const std::uint32_t anchor : anchors) {
    const auto neighbors = graph.of(anchor);
    const bool is_inner = std::all_of(neighbors.begin(), neighbors.end(),
                                      [&](std::uint32_t neighbor) { return is_anchor[neighbor] != 0; });
    count[components.label[anchor]] += is_inner ? 1 : 0;
  }
  return count;
}

/// The graph as it is.
Group whole(const Adjacency& graph, Components components, std::span<const std::uint32_t> anchors,
            std::uint32_t depth) {
  Group group;
  group.depth = depth;
  group.anchors.assign(anchors.begin(), anchors.end());
  group.anchor_of.resize(anchors.size());
  std::iota(group.anchor_of.begin(), group.anchor_of.end(), 0U);
  group.graph = &graph;
  group.components = std::move(components);
  return group;
}

}  // namespace

std::vector<std::uint32_t> component_depths(const Adjacency& graph, const Components& components,
                                            std::span<const std::uint32_t> anchors) {
  std::vector<std::uint32_t> anchor_count(components.count, 0);
  for (const std::uint32_t anchor : anchors) ++anchor_count[components.label[anchor]];
  const std::vector<std::uint32_t> inner_count = count_inner_anchors(graph, components, anchors);
  std::vector<std::uint32_t> depth(components.count, 0);
  for (std::uint32_t c = 0; c < components.count; ++c) {
    depth[c] = components.size[c] <= SmallComponents::kLargest
                   ? kInNoGroup
                   : coarsening_depth(components.size[c] - inner_count[c], anchor_count[c] - inner_count[c]);
  }
  return depth;
}

std::vector<Group> group_components(const Adjacency& graph, Components components,
                                    std::span<const std::uint32_t> anchors) {
  const std::vector<std::uint32_t> depth = component_depths(graph, components, anchors);
  std::vector<Group> groups;
  if (std::adjacent_find(depth.begin(), depth.end(), std::not_equal_to<>()) == depth.end() &&
      !depth.empty() && depth.front() != kInNoGroup) {
    groups.push_back(whole(graph, std::move(components), anchors, depth.front()));
    return groups;
  }
  std::vector<std::uint32_t> depths = depth;
  std::sort(depths.begin(), depths.end());
  depths.erase(std::unique(depths.begin(), depths.end()), depths.end());
  for (const std::uint32_t d : depths) {
    if (d != kInNoGroup) groups.push_back(extract(graph, components, anchors, depth, d));
  }
  return groups;
}

Group extract_components(const Group& group, std::span<const std::uint8_t> chosen) {
  std::vector<std::uint32_t> key(chosen.size());
  for (std::size_t c = 0; c < key.size(); ++c) key[c] = chosen[c] != 0 ? 0 : 1;
  return extract(*group.graph, group.components, group.anchors, key, 0);
}

}  // namespace deltamesh::settling
