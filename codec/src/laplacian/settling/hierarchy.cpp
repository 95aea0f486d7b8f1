// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/hierarchy.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "laplacian/settling/aggregate.h"
#include "laplacian/settling/galerkin.h"
#include "laplacian/settling/make_interpolation.h"
#include "laplacian/settling/padding.h"

namespace deltamesh::settling {
namespace {

/// Of triangle meshes, measured: what the first coarsening and every further one divide the number of nodes
/// by.
constexpr double kFirstShrinkage = 3.5;
constexpr double kShrinkage = 4.8;

/// Coarser levels could not tell the anchors apart.
constexpr double kFewestNodesPerAnchor = 1;
constexpr double kFewestPerRow = 1.5;

/// Of all coarser levels and of all cycles on them, over the work on the finest level. Meshes need about 1;
/// where many anchors lie together, or few edges lead out of dense parts, levels hardly shrink.
constexpr std::uint64_t kMostWork = 4;

/// What 32 bits can count, and what pad_rows() may add to a node's.
constexpr std::uint64_t kMostEdgeEnds = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint64_t kMostPadding = 2 * (kEdgesAtOnce - 1);

/// Of a coarse level; with less, threads would wait for each other.
constexpr std::uint32_t kFewestNodesToShare = std::uint32_t{1} << 15;

/// Without D and M.
Level finest_level(const Adjacency& graph, std::span<const std::uint32_t> anchors) {
  Level level;
  level.offsets = graph.offsets;
  level.neighbors = graph.neighbors;
  level.edge_ends = graph.neighbors.size();
  level.anchors.assign(anchors.begin(), anchors.end());
  return level;
}

float unit_degree(const Level& finest, std::uint32_t node) noexcept {
  return static_cast<float>(finest.offsets[node + 1] - finest.offsets[node]);
}

void set_diagonal(Level& finest) {
  const std::uint32_t n = finest.node_count();
  finest.degree.resize(n);
  finest.inverse_degree.resize(n);
  finest.mass.resize(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    const float degree = unit_degree(finest, i);
    finest.degree[i] = degree;
    finest.inverse_degree[i] = degree > 0 ? 1 / degree : 0;
    finest.mass[i] = degree * degree;
  }
}

/// P^T M.
LargeVector<float> restrict_mass(const Level& fine, std::uint32_t nodes) {
  LargeVector<float> coarse(nodes, 0.0F);
  fine.chunks.visit([&](std::uint32_t i) {
    fine.interpolation[i].spread(fine.mass[i], [&](std::uint32_t node) -> float& { return coarse[node]; });
  });
  return coarse;
}

/// The next level, from P and the chunks of `fine`; false where it would have more edges.
bool coarsen(const Level& fine, const Aggregates& aggregates, float smallest, Level& coarse) {
  if (!make_galerkin_graph(fine, aggregates.count(), smallest, coarse)) return false;
  coarse.mass = restrict_mass(fine, aggregates.count());
  if (coarse.edge_ends + kMostPadding * aggregates.count() > kMostEdgeEnds) return false;
  coarse.anchors.reserve(fine.anchors.size());
  for (const std::uint32_t anchor : fine.anchors) coarse.anchors.push_back(aggregates.of(anchor));
  return true;
}

/// For every bound the first aggregate whose seed is not below.
std::vector<std::uint32_t> places_of(std::span<const std::uint32_t> bounds, const Aggregates& aggregates) {
  std::vector<std::uint32_t> places;
  for (const std::uint32_t bound : bounds) {
    const auto place = std::lower_bound(
        aggregates.start.begin(), aggregates.start.end() - 1, bound,
        [&](std::uint32_t first, std::uint32_t value) { return aggregates.members[first] < value; });
    places.push_back(static_cast<std::uint32_t>(place - aggregates.start.begin()));
  }
  return places;
}

bool is_worth_sharing(const Level& level) noexcept { return level.node_count() >= kFewestNodesToShare; }

/// Whether there is a component without an anchor: small entries were all that held it.
bool is_cut(const Level& level) {
  const Components components = find_components(level.storage);
  std::vector<std::uint8_t> has_anchor(components.count, 0);
  for (const std::uint32_t anchor : level.anchors) has_anchor[components.label[anchor]] = 1;
  return std::find(has_anchor.begin(), has_anchor.end(), 0) != has_anchor.end();
}

std::vector<Level> build_levels(const Adjacency& graph, std::span<const std::uint32_t> anchors,
                                std::uint32_t depth, float smallest) {
  std::vector<Level> levels;
  levels.push_back(finest_level(graph, anchors));
  set_diagonal(levels.front());
  const std::uint64_t most = kMostWork * work_on(levels.front());
  std::uint64_t work = 0;
  std::vector<std::uint32_t> bounds = chunk_bounds(levels.front().node_count());
  while (levels.size() <= depth && work < most) {
    Level& fine = levels.back();
    work += work_on(fine);
    const Aggregates aggregates = aggregate(fine);
    const std::size_t held = fine.anchors.size();  // these stay
    if (5 * (aggregates.count() - held) >= 4 * (fine.node_count() - held)) break;
    if (aggregates.count() > Interpolation::kMostNodes) break;
    fine.interpolation = make_interpolation(fine, aggregates);
    std::vector<std::uint32_t> coarse_bounds = places_of(bounds, aggregates);
    fine.chunks = make_chunks(fine, std::move(bounds), coarse_bounds);
    Level coarse;
    if (!coarsen(fine, aggregates, smallest, coarse)) {
      bounds = std::move(fine.chunks.bounds);
      fine.interpolation.clear();
      break;
    }
    bounds = is_worth_sharing(coarse) ? std::move(coarse_bounds)
                                      : std::vector<std::uint32_t>{0, coarse.node_count()};
    levels.push_back(std::move(coarse));
  }
  levels.back().chunks = make_chunks(levels.back(), std::move(bounds), {});
  return levels;
}

}  // namespace

std::uint32_t coarsening_depth(std::uint32_t vertices, std::uint32_t anchors) noexcept {
  const double fewest = std::max(kFewestPerRow, kFewestNodesPerAnchor * anchors);
  std::uint32_t depth = 1;
  for (double nodes = vertices / (kFirstShrinkage * kShrinkage); nodes >= fewest; nodes /= kShrinkage)
    ++depth;
  return depth;
}

std::vector<Level> build_hierarchy(const Adjacency& graph, std::span<const std::uint32_t> anchors,
                                   std::uint32_t depth) {
  std::vector<Level> levels = build_levels(graph, anchors, depth, kSmallEntry);
  if (levels.size() > 1 && is_cut(levels.back())) levels = build_levels(graph, anchors, depth, 0.0F);
  while (levels.size() > 1 && is_cut(levels.back())) {
    levels.pop_back();
    levels.back().interpolation.clear();
  }
  for (Level& level : std::span(levels).subspan(1)) pad_rows(level);
  return levels;
}

std::uint64_t work_on(const Level& level) noexcept { return level.node_count() + level.edge_ends; }

std::vector<int> plan_cycles(std::span<const Level> levels) {
  std::vector<int> cycles(levels.size(), 1);
  const std::uint64_t most = kMostWork * work_on(levels.front());
  std::uint64_t visits = 1;
  std::uint64_t work = 0;
  for (std::size_t level = 1; level < levels.size(); ++level) {
    if (work + 2 * visits * work_on(levels[level]) <= most) {
      cycles[level] = 2;
      visits *= 2;
    }
    work += visits * work_on(levels[level]);
  }
  return cycles;
}

}  // namespace deltamesh::settling
