// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "topology/adjacency.h"

#include <array>
#include <cstddef>
#include <utility>

namespace deltamesh {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;

/// The six directed edges of a face, without those from a vertex to itself.
template <class Visit>
void for_each_directed_edge(std::span<const std::uint32_t> triangles, Visit&& visit) {
  for (std::size_t f = 0; f + 2 < triangles.size(); f += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[f + k];
      const std::uint32_t b = triangles[f + (k + 1) % 3];
      if (a == b) continue;
      visit(a, b);
      visit(b, a);
    }
  }
}

/// Counts in places 1 .. n become the offsets of rows 0 .. n.
void sum_up(std::vector<std::uint32_t>& offsets) {
  for (std::size_t v = 1; v < offsets.size(); ++v) offsets[v] += offsets[v - 1];
}

/// The same symmetric graph with ascending rows: row w receives every v in ascending order of v.
std::vector<std::uint32_t> transpose(const std::vector<std::uint32_t>& offsets,
                                     const std::vector<std::uint32_t>& neighbors) {
  std::vector<std::uint32_t> cursor(offsets.begin(), offsets.end() - 1);
  std::vector<std::uint32_t> sorted(neighbors.size());
  for (std::uint32_t v = 0; v + 1 < offsets.size(); ++v) {
    for (std::uint32_t i = offsets[v]; i < offsets[v + 1]; ++i) sorted[cursor[neighbors[i]]++] = v;
  }
  return sorted;
}

/// Drops repeated entries of ascending rows, in place.
void drop_repeats(Adjacency& graph) {
  std::uint32_t kept = 0;
  std::uint32_t begin = 0;
  for (std::size_t v = 0; v + 1 < graph.offsets.size(); ++v) {
    const std::uint32_t end = graph.offsets[v + 1];
    for (std::uint32_t i = begin; i < end; ++i) {
      if (i == begin || graph.neighbors[i] != graph.neighbors[i - 1])
        graph.neighbors[kept++] = graph.neighbors[i];
    }
    begin = end;
    graph.offsets[v + 1] = kept;
  }
  graph.neighbors.resize(kept);
}

}  // namespace

Adjacency build_adjacency(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count) {
  Adjacency graph;
  graph.offsets.assign(std::size_t{vertex_count} + 1, 0);
  for_each_directed_edge(triangles, [&](std::uint32_t a, std::uint32_t) { ++graph.offsets[a + 1]; });
  sum_up(graph.offsets);

  graph.neighbors.resize(graph.offsets.back());
  std::vector<std::uint32_t> cursor(graph.offsets.begin(), graph.offsets.end() - 1);
  for_each_directed_edge(triangles,
                         [&](std::uint32_t a, std::uint32_t b) { graph.neighbors[cursor[a]++] = b; });
  graph.neighbors = transpose(graph.offsets, graph.neighbors);
  drop_repeats(graph);
  return graph;
}

Components find_components(const Adjacency& graph) {
  const std::size_t n = graph.vertex_count();
  Components components;
  components.label.assign(n, kNone);
  std::vector<std::uint32_t> queue;
  for (std::uint32_t seed = 0; seed < n; ++seed) {
    if (components.label[seed] != kNone) continue;
    const std::uint32_t label = components.count++;
    components.label[seed] = label;
    queue.assign(1, seed);
    for (std::size_t next = 0; next < queue.size(); ++next) {
      for (const std::uint32_t w : graph.of(queue[next])) {
        if (components.label[w] != kNone) continue;
        components.label[w] = label;
        queue.push_back(w);
      }
    }
    components.size.push_back(static_cast<std::uint32_t>(queue.size()));
  }
  return components;
}

}  // namespace deltamesh
