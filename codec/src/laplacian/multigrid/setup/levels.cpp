// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid/setup/levels.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "laplacian/multigrid/setup/aggregates.h"
#include "laplacian/multigrid/setup/coarse_graph.h"
#include "laplacian/multigrid/setup/make_interpolation.h"

namespace deltamesh::multigrid {
namespace {

/// Of a level that is coarsened. The coarsest one then has a few nodes for each anchor, at which few
/// iterations solve it.
constexpr std::size_t kFewestNodesPerAnchor = 5;

/// Coarse levels whose edges are paths between seeds; P^T K P, which is dearer, for those below, where paths
/// are wrong about what hangs by few edges.
constexpr std::size_t kLevelsByPaths = 2;

Level finest_level(const Adjacency& graph, std::span<const std::uint32_t> anchors) {
  Level level;
  level.offsets = graph.offsets;
  level.neighbors = graph.neighbors;
  level.anchors.assign(anchors.begin(), anchors.end());
  return level;
}

/// P^T M.
LargeVector<float> restrict_mass(const Level& fine, std::uint32_t nodes) {
  LargeVector<float> coarse(nodes, 0.0F);
  for (std::uint32_t i = 0; i < fine.node_count(); ++i) {
    const float mass = fine.mass.empty() ? unit_degree(fine, i) * unit_degree(fine, i) : fine.mass[i];
    fine.interpolation[i].spread(mass, [&](std::uint32_t node) -> float& { return coarse[node]; });
  }
  return coarse;
}

/// Takes the interpolation from it as well.
Level coarsen(Level& fine, const Aggregates& aggregates, bool by_paths, ThreadTeam* team) {
  fine.interpolation = make_interpolation(fine, aggregates, team);
  Level coarse;
  make_coarse_graph(fine, aggregates, by_paths, coarse, team);
  coarse.mass = restrict_mass(fine, aggregates.count());
  for (std::uint32_t a = 0; a < fine.anchors.size(); ++a) {
    if (aggregates.codes[fine.anchors[a]] == Aggregates::kNone) continue;
    coarse.anchors.push_back(aggregates.of(fine.anchors[a]));
    coarse.finer_anchors.push_back(a);
  }
  return coarse;
}

/// Few are left of an anchor that is alone in its component, and no edges among them soon.
std::size_t anchors_with_edges(const Level& level) noexcept {
  const auto has_edges = [&](std::uint32_t node) { return level.offsets[node] < level.offsets[node + 1]; };
  return static_cast<std::size_t>(std::count_if(level.anchors.begin(), level.anchors.end(), has_edges));
}

bool is_coarse(const Level& level) noexcept {
  const std::size_t fewest = kFewestNodesPerAnchor * anchors_with_edges(level);
  return level.node_count() < std::max<std::size_t>(fewest, kFewestNodesToCoarsen);
}

bool is_next(std::uint64_t coarse, std::uint64_t fine) noexcept {
  return coarse > 0 && 5 * coarse <= 4 * fine && coarse <= Interpolation::kMostNodes;
}

}  // namespace

std::vector<Level> build_levels(const Adjacency& graph, std::span<const std::uint32_t> anchors,
                                ThreadTeam* team) {
  std::vector<Level> levels;
  levels.push_back(finest_level(graph, anchors));
  while (!is_coarse(levels.back())) {
    const Aggregates aggregates = aggregate(levels.back());
    if (!is_next(aggregates.count(), levels.back().node_count())) break;
    Level coarse = coarsen(levels.back(), aggregates, levels.size() <= kLevelsByPaths, team);
    if (coarse.edge_count() > levels.front().edge_count()) {
      levels.back().interpolation.clear();
      break;
    }
    levels.push_back(std::move(coarse));
  }
  return levels;
}

void add_weights(Level& finest) {
  const std::uint32_t nodes = finest.node_count();
  finest.weights.assign(finest.neighbors.size(), 1.0F);
  for (std::uint32_t i = 0; i < nodes; ++i) {
    const auto row = finest.neighbors.subspan(finest.offsets[i], finest.offsets[i + 1] - finest.offsets[i]);
    const auto higher = std::lower_bound(row.begin(), row.end(), i);
    const float degree = unit_degree(finest, i);
    finest.middle.push_back(finest.offsets[i] + static_cast<std::uint32_t>(higher - row.begin()));
    finest.degree.push_back(degree);
    finest.inverse_degree.push_back(1 / degree);
    finest.mass.push_back(degree * degree);
  }
}

}  // namespace deltamesh::multigrid
