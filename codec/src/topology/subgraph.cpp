// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "topology/subgraph.h"

#include <algorithm>
#include <span>
#include <vector>

namespace deltamesh {
namespace {

/// Neighbours that are renumbered at once: if one of them is not in their run, they are gone through again.
constexpr std::uint32_t kAtOnce = 256;

/// Vertices become rows; most of them are in `run`.
void renumber(std::span<std::uint32_t> vertices, const VertexSubset::Run& run, const VertexSubset& kept) {
  const std::uint32_t size = run.size();
  std::uint32_t outside = 0;
  for (std::uint32_t& v : vertices) {
    v -= run.begin;
    outside |= v >= size ? 1 : 0;
    v += run.row;
  }
  if (outside == 0) return;
  for (std::uint32_t& v : vertices) {
    if (v - run.row >= size) v = *kept.row_of(v - run.row + run.begin);
  }
}

/// `part` has room and may be `graph`: rows only move to the front. Returns how many neighbours there are.
std::uint32_t take_rows(const Adjacency& graph, const VertexSubset& kept, Adjacency& part) {
  std::uint32_t written = 0;
  for (const auto& run : kept.runs()) {
    const std::uint32_t from = graph.offsets[run.begin];
    const std::uint32_t count = graph.offsets[run.end] - from;
    for (std::uint32_t i = 0; i < run.size(); ++i)
      part.offsets[run.row + i] = graph.offsets[run.begin + i] - from + written;
    std::uint32_t* const neighbors = part.neighbors.data() + written;
    if (neighbors != graph.neighbors.data() + from)
      std::copy_n(graph.neighbors.data() + from, count, neighbors);
    for (std::size_t i = 0; i < count; i += kAtOnce)
      renumber({neighbors + i, std::min<std::size_t>(kAtOnce, count - i)}, run, kept);
    written += count;
  }
  return written;
}

/// Gives back what is not needed, where that is much.
template <class T>
void shrink(LargeVector<T>& values, std::size_t size) {
  values.resize(size);
  if (values.capacity() - size > size / 8) values.shrink_to_fit();
}

}  // namespace

Adjacency copy_vertices(const Adjacency& graph, const VertexSubset& kept) {
  Adjacency part;
  std::size_t neighbors = 0;
  for (const auto& run : kept.runs()) neighbors += graph.offsets[run.end] - graph.offsets[run.begin];
  part.offsets.resize(kept.size() + 1);
  part.neighbors.resize(neighbors);
  part.offsets.back() = take_rows(graph, kept, part);
  return part;
}

void keep_vertices(Adjacency& graph, const VertexSubset& kept) {
  const std::uint32_t neighbors = take_rows(graph, kept, graph);
  shrink(graph.offsets, kept.size() + 1);
  graph.offsets.back() = neighbors;
  shrink(graph.neighbors, neighbors);
}

/// Kept vertices ascend, so that components are met in the order of their smallest vertices.
Components pick_components(const Components& components, const VertexSubset& kept) {
  constexpr std::uint32_t kUnmet = 0xffffffff;
  std::vector<std::uint32_t> label(components.count, kUnmet);
  Components part;
  part.label.resize(kept.size());
  gather_rows(std::span<const std::uint32_t>(components.label), kept, std::span(part.label));
  for_each_run(part, [&](std::uint32_t begin, std::uint32_t end, std::uint32_t c) {
    if (label[c] == kUnmet) {
      label[c] = part.count++;
      part.size.push_back(components.size[c]);
    }
    std::fill(part.label.begin() + begin, part.label.begin() + end, label[c]);
  });
  return part;
}

}  // namespace deltamesh
