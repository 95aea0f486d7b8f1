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
Level coarsen(Level& fine, const Aggregates& aggregates) {
  fine.interpolation = make_interpolation(fine, aggregates);
  Level coarse;
  make_coarse_graph(fine, aggregates, coarse);
  coarse.mass = restrict_mass(fine, aggregates.count());
  for (const std::uint32_t anchor : fine.anchors) coarse.anchors.push_back(aggregates.of(anchor));
  return coarse;
}

bool is_much_smaller(std::uint64_t coarse, std::uint64_t fine) noexcept { return 5 * coarse <= 4 * fine; }

}  // namespace

std::vector<Level> build_levels(const Adjacency& graph, std::span<const std::uint32_t> anchors) {
  std::vector<Level> levels;
  levels.push_back(finest_level(graph, anchors));
  while (levels.back().node_count() >=
         std::max<std::size_t>(kFewestNodesPerAnchor * anchors.size(), kFewestNodesToCoarsen)) {
    const Aggregates aggregates = aggregate(levels.back());
    if (!is_much_smaller(aggregates.count(), levels.back().node_count())) break;
    if (aggregates.count() > Interpolation::kMostNodes) break;
    Level coarse = coarsen(levels.back(), aggregates);
    levels.push_back(std::move(coarse));
  }
  return levels;
}

}  // namespace deltamesh::multigrid
