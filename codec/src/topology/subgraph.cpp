// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "topology/subgraph.h"

#include "base/large_vector.h"

namespace deltamesh {
namespace {

/// New number of every kept vertex; anything for the others, which are no neighbours of these.
LargeVector<std::uint32_t> renumbering(std::size_t vertex_count, std::span<const std::uint32_t> kept) {
  LargeVector<std::uint32_t> row(vertex_count);
  for (std::uint32_t i = 0; i < kept.size(); ++i) row[kept[i]] = i;
  return row;
}

}  // namespace

std::vector<bool> mark_vertices(std::span<const std::uint32_t> kept, std::size_t count) {
  std::vector<bool> marks(count, false);
  for (const std::uint32_t vertex : kept) marks[vertex] = true;
  return marks;
}

Adjacency copy_vertices(const Adjacency& graph, std::span<const std::uint32_t> kept) {
  const LargeVector<std::uint32_t> row = renumbering(graph.vertex_count(), kept);
  Adjacency part;
  part.offsets.reserve(kept.size() + 1);
  part.offsets.push_back(0);
  std::uint32_t total = 0;
  for (const std::uint32_t vertex : kept) part.offsets.push_back(total += graph.degree(vertex));
  part.neighbors.reserve(total);
  for (const std::uint32_t vertex : kept) {
    for (const std::uint32_t neighbor : graph.of(vertex)) part.neighbors.push_back(row[neighbor]);
  }
  return part;
}

/// Rows only move to the front, and row i is written after kept[i] >= i was read.
void keep_vertices(Adjacency& graph, std::span<const std::uint32_t> kept) {
  const LargeVector<std::uint32_t> row = renumbering(graph.vertex_count(), kept);
  std::uint32_t written = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const std::uint32_t end = graph.offsets[kept[i] + 1];
    std::uint32_t from = graph.offsets[kept[i]];
    graph.offsets[i] = written;
    for (; from < end; ++from) graph.neighbors[written++] = row[graph.neighbors[from]];
  }
  graph.offsets.resize(kept.size() + 1);
  graph.offsets.back() = written;
  graph.neighbors.resize(written);
}

/// Kept vertices ascend, so that components are met in the order of their smallest vertices.
Components pick_components(const Components& components, std::span<const std::uint32_t> kept) {
  constexpr std::uint32_t kUnmet = 0xffffffff;
  std::vector<std::uint32_t> label(components.count, kUnmet);
  Components part;
  part.label.reserve(kept.size());
  for (const std::uint32_t vertex : kept) {
    const std::uint32_t c = components.label[vertex];
    if (label[c] == kUnmet) {
      label[c] = part.count++;
      part.size.push_back(components.size[c]);
    }
    part.label.push_back(label[c]);
  }
  return part;
}

}  // namespace deltamesh
