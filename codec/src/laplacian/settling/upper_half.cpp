// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/upper_half.h"

#include <algorithm>
#include <utility>

namespace deltamesh::settling {
namespace {

/// Keeps the entries that are not small.
void drop_small(UpperHalf& upper, float smallest) {
  Entry* const entries = upper.rows.entries.data();
  const float* const largest = upper.largest.data();
  std::uint32_t kept = 0;
  std::uint32_t e = 0;
  for (std::uint32_t c = 0; c < upper.largest.size(); ++c) {
    for (const std::uint32_t end = upper.rows.start[c + 1]; e < end; ++e) {
      const Entry entry = entries[e];
      entries[kept] = entry;  // no branch: it could not be predicted
      kept += entry.weight >= smallest * std::min(largest[c], largest[entry.node]) ? 1 : 0;
    }
    upper.rows.start[c + 1] = kept;
  }
  upper.rows.entries.resize(kept);
}

/// Both halves, in every row first the edges to lower nodes.
void mirror(const UpperHalf& upper, Level& coarse) {
  const auto nodes = static_cast<std::uint32_t>(upper.largest.size());
  auto& offsets = coarse.storage.offsets;
  offsets.assign(nodes + 1, 0);
  for (std::uint32_t c = 0; c < nodes; ++c) offsets[c + 1] = upper.rows.start[c + 1] - upper.rows.start[c];
  for (const Entry& entry : upper.rows.entries) ++offsets[entry.node + 1];
  for (std::uint32_t c = 0; c < nodes; ++c) offsets[c + 1] += offsets[c];
  coarse.storage.neighbors.resize(offsets[nodes]);
  coarse.weights.resize(offsets[nodes]);
  coarse.middle.resize(nodes);
  LargeVector<std::uint32_t> next(offsets.begin(), offsets.end() - 1);
  const auto put = [&](std::uint32_t from, std::uint32_t to, float weight) {
    coarse.storage.neighbors[next[from]] = to;
    coarse.weights[next[from]++] = weight;
  };
  for (std::uint32_t c = 0; c < nodes; ++c) {
    coarse.middle[c] = next[c];
    for (std::uint32_t e = upper.rows.start[c]; e < upper.rows.start[c + 1]; ++e) {
      put(c, upper.rows.entries[e].node, upper.rows.entries[e].weight);
      put(upper.rows.entries[e].node, c, upper.rows.entries[e].weight);
    }
  }
  coarse.offsets = coarse.storage.offsets;
  coarse.neighbors = coarse.storage.neighbors;
  coarse.edge_ends = coarse.neighbors.size();
}

}  // namespace

void make_graph(UpperHalf upper, float smallest, Level& coarse) {
  drop_small(upper, smallest);
  mirror(upper, coarse);
  set_degrees(coarse);
}

void set_degrees(Level& level) {
  const std::uint32_t nodes = level.node_count();
  level.degree.resize(nodes);
  level.inverse_degree.resize(nodes);
  for (std::uint32_t i = 0; i < nodes; ++i) {
    float degree = 0;
    for (std::uint32_t e = level.offsets[i]; e < level.offsets[i + 1]; ++e) degree += level.weights[e];
    level.degree[i] = degree;
    level.inverse_degree[i] = degree > 0 ? 1 / degree : 0;
  }
}

}  // namespace deltamesh::settling
