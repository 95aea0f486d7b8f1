// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid_hierarchy.h"

#include <algorithm>
#include <array>
#include <utility>

#include "laplacian/multigrid_aggregate.h"
#include "laplacian/multigrid_transfer.h"

namespace deltamesh::multigrid {
namespace {

constexpr double kFewestNodesPerAnchor = 3.5;
constexpr double kShrinkage = 3.65;  // of a triangle mesh, measured

/// Coarse edge weights over Galerkin's diagonal, which spreads over more neighbours: 1.2 converges fastest on
/// scans, terrain and maps taken together.
constexpr float kGalerkinScale = 1.2F;

Level finest_level(const Adjacency& graph, std::span<const std::uint32_t> anchors) {
  Level level;
  level.offsets = graph.offsets;
  level.neighbors = graph.neighbors;
  level.anchors.assign(anchors.begin(), anchors.end());
  const std::uint32_t n = level.node_count();
  level.degree.resize(n);
  level.inverse_degree.resize(n);
  level.mass.resize(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    const auto degree = static_cast<float>(graph.degree(i));
    level.degree[i] = degree;
    level.inverse_degree[i] = degree > 0 ? 1 / degree : 0;
    level.mass[i] = degree * degree;
  }
  return level;
}

/// What `p` gives to `node`; 0 where it does not know it.
float weight_of(const Interpolation& p, std::uint32_t node) noexcept {
  return (p.node[0] == node ? p.weight[0] : 0.0F) + (p.node[1] == node ? p.weight[1] : 0.0F) +
         (p.node[2] == node ? p.weight[2] : 0.0F);
}

/// The edges of node i in the diagonal of P^T K P, for the nodes that i is interpolated from. An edge both of
/// whose ends know a node is met twice, half each time.
std::array<float, 3> edge_energy(const Level& fine, std::uint32_t i) noexcept {
  const Interpolation& p = fine.interpolation[i];
  std::array<float, 3> energy{};
  for (std::uint32_t e = fine.offsets[i]; e < fine.offsets[i + 1]; ++e) {
    const Interpolation& q = fine.interpolation[fine.neighbors[e]];
    for (std::size_t k = 0; k < 3; ++k) {
      const float other = weight_of(q, p.node[k]);
      const float slope = p.weight[k] - other;
      energy[k] += (other > 0 ? 0.5F : 1.0F) * fine.weight(e) * slope * slope;
    }
  }
  return energy;
}

/// Plain aggregation makes the coarse K too stiff, on a regular mesh by 2.2 or so, less at rims and tips, and
/// by nothing where a component is down to a few nodes. So each node's stiffness is scaled to that of the
/// interpolation: diagonal of P^T K P over diagonal of the aggregated K.
std::vector<float> stiffness_scale(const Level& fine, const Aggregates& aggregates) {
  std::vector<float> galerkin(aggregates.seeds.size(), 0.0F);
  std::vector<float> plain(aggregates.seeds.size(), 0.0F);
  for (std::uint32_t i = 0; i < fine.node_count(); ++i) {
    const std::array<float, 3> energy = edge_energy(fine, i);
    const Interpolation& p = fine.interpolation[i];
    for (std::size_t k = 0; k < 3; ++k) galerkin[p.node[k]] += p.weight[k] > 0 ? energy[k] : 0.0F;
    for (std::uint32_t e = fine.offsets[i]; e < fine.offsets[i + 1]; ++e) {
      if (aggregates.of[i] != aggregates.of[fine.neighbors[e]]) plain[aggregates.of[i]] += fine.weight(e);
    }
  }
  for (std::size_t c = 0; c < plain.size(); ++c)
    galerkin[c] = plain[c] > 0 ? kGalerkinScale * galerkin[c] / plain[c] : 0.0F;
  return galerkin;
}

/// Nodes sorted by aggregate: those of c are nodes[start[c] .. start[c + 1]).
struct Members {
  explicit Members(const Aggregates& aggregates)
      : start(aggregates.seeds.size() + 1, 0), nodes(aggregates.of.size()) {
    for (const std::uint32_t c : aggregates.of) ++start[c + 1];
    for (std::size_t c = 1; c < start.size(); ++c) start[c] += start[c - 1];
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    for (std::uint32_t i = 0; i < aggregates.of.size(); ++i) nodes[next[aggregates.of[i]]++] = i;
  }
  std::vector<std::uint32_t> start;
  std::vector<std::uint32_t> nodes;
};

/// Edge weights between aggregates, summed and scaled; degrees.
void build_coarse_graph(const Level& fine, const Aggregates& aggregates, Level& coarse) {
  const std::vector<float> scale = stiffness_scale(fine, aggregates);
  const Members members(aggregates);
  std::vector<float> sums(scale.size(), 0.0F);
  std::vector<std::uint32_t>& offsets = coarse.storage.offsets;
  std::vector<std::uint32_t>& neighbors = coarse.storage.neighbors;
  offsets.assign(1, 0);
  for (std::uint32_t c = 0; c < scale.size(); ++c) {
    const std::size_t first = neighbors.size();
    for (std::uint32_t m = members.start[c]; m < members.start[c + 1]; ++m) {
      const std::uint32_t i = members.nodes[m];
      for (std::uint32_t e = fine.offsets[i]; e < fine.offsets[i + 1]; ++e) {
        const std::uint32_t other = aggregates.of[fine.neighbors[e]];
        if (other == c) continue;
        if (sums[other] == 0) neighbors.push_back(other);
        sums[other] += fine.weight(e);
      }
    }
    float degree = 0;
    for (std::size_t e = first; e < neighbors.size(); ++e) {
      const std::uint32_t other = neighbors[e];
      coarse.weights.push_back(0.5F * (scale[c] + scale[other]) * std::exchange(sums[other], 0.0F));
      degree += coarse.weights.back();
    }
    coarse.degree.push_back(degree);
    coarse.inverse_degree.push_back(degree > 0 ? 1 / degree : 0);
    offsets.push_back(static_cast<std::uint32_t>(neighbors.size()));
  }
  coarse.offsets = offsets;
  coarse.neighbors = neighbors;
}

Level coarsen(const Level& fine, const Aggregates& aggregates) {
  Level coarse;
  build_coarse_graph(fine, aggregates, coarse);
  coarse.mass.assign(aggregates.seeds.size(), 0.0F);
  for (std::uint32_t i = 0; i < fine.node_count(); ++i) {
    const Interpolation& p = fine.interpolation[i];
    for (std::size_t k = 0; k < 3; ++k) coarse.mass[p.node[k]] += p.weight[k] * fine.mass[i];
  }
  coarse.anchors.reserve(fine.anchors.size());
  for (const std::uint32_t anchor : fine.anchors) coarse.anchors.push_back(aggregates.of[anchor]);
  return coarse;
}

}  // namespace

std::uint32_t coarsening_depth(std::uint32_t vertices, std::uint32_t anchors) noexcept {
  std::uint32_t depth = 1;
  for (double nodes = vertices / (kShrinkage * kShrinkage);
       nodes >= kFewestNodesPerAnchor * std::max(anchors, 1U); nodes /= kShrinkage)
    ++depth;
  return depth;
}

std::vector<Level> build_hierarchy(const Adjacency& graph, std::span<const std::uint32_t> anchors,
                                   std::uint32_t depth) {
  std::vector<Level> levels;
  levels.push_back(finest_level(graph, anchors));
  while (levels.size() <= depth) {
    Level& fine = levels.back();
    const Aggregates aggregates = aggregate(fine);
    const std::size_t held = fine.anchors.size();  // these stay
    if (5 * (aggregates.seeds.size() - held) >= 4 * (fine.node_count() - held)) break;
    fine.interpolation = make_interpolation(fine, aggregates);
    levels.push_back(coarsen(fine, aggregates));
  }
  return levels;
}

}  // namespace deltamesh::multigrid
