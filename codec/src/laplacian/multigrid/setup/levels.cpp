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
  for (const std::uint32_t anchor : fine.anchors) coarse.anchors.push_back(aggregates.of(anchor));
  return coarse;
}

/// The finest level is coarsened in any case: x alone is kept there, s and the forces begin on the second.
bool is_coarse(const Level& level, bool is_finest) noexcept {
  const std::size_t fewest = is_finest ? 0 : kFewestNodesPerAnchor * level.anchors.size();
  return level.node_count() < std::max<std::size_t>(fewest, kFewestNodesToCoarsen);
}

bool is_next(std::uint64_t coarse, std::uint64_t fine, bool is_finest) noexcept {
  return (is_finest || 5 * coarse <= 4 * fine) && coarse <= Interpolation::kMostNodes;
}

}  // namespace

Level finest_level(const Adjacency& graph, std::span<const std::uint32_t> anchors) {
  Level level;
  level.offsets = graph.offsets;
  level.neighbors = graph.neighbors;
  level.anchors.assign(anchors.begin(), anchors.end());
  return level;
}

std::vector<Level> build_levels(const Adjacency& graph, std::span<const std::uint32_t> anchors,
                                ThreadTeam* team) {
  std::vector<Level> levels;
  levels.push_back(finest_level(graph, anchors));
  while (!is_coarse(levels.back(), levels.size() == 1)) {
    const Aggregates aggregates = aggregate(levels.back());
    if (!is_next(aggregates.count(), levels.back().node_count(), levels.size() == 1)) break;
    Level coarse = coarsen(levels.back(), aggregates, levels.size() <= kLevelsByPaths, team);
    if (coarse.edge_count() > levels.front().edge_count()) {
      levels.back().interpolation.clear();
      break;
    }
    levels.push_back(std::move(coarse));
  }
  return levels;
}

}  // namespace deltamesh::multigrid
