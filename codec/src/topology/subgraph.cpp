// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "topology/subgraph.h"

#include <algorithm>
#include <vector>

namespace deltamesh {
namespace {

/// Neighbours that are renumbered at once: if one of them is not in their run, they are gone through again.
constexpr std::uint32_t kAtOnce = 256;

/// Vertices become rows; most of them are in `run`, which is a copy, so that it is known to stay as it is.
void renumber(std::span<std::uint32_t> vertices, const VertexSubset::Run run, const VertexSubset& kept) {
  const std::uint32_t last = run.size() - 1;
  std::uint32_t outside = 0;  // the upper bit: set if one of them is
  for (std::uint32_t& v : vertices) {
    const std::uint32_t place = v - run.begin;
    outside |= place | (last - place);
    v = place + run.row;
  }
  if (outside >> 31 == 0) return;
  for (std::uint32_t& v : vertices) {
    if (v - run.row > last) v = *kept.row_of(v - run.row + run.begin);
  }
}

/// `to` may be `from`, or before it.
void copy(std::span<const std::uint32_t> from, std::uint32_t* to) {
  if (to != from.data()) std::copy(from.begin(), from.end(), to);
}

/// `part` has room and may be `graph`: rows only move to the front. Returns how many neighbours there are.
std::uint32_t take_rows(const Adjacency& graph, const VertexSubset& kept, Adjacency& part) {
  std::uint32_t written = 0;
  for (const auto& run : kept.runs()) {
    const std::uint32_t from = graph.offsets[run.begin];
    const std::uint32_t count = graph.offsets[run.end] - from;
    const std::span offsets(part.offsets.data() + run.row, run.size());
    copy({graph.offsets.data() + run.begin, run.size()}, offsets.data());
    for (std::uint32_t& offset : offsets) offset += written - from;
    const std::span neighbors(part.neighbors.data() + written, count);
    copy({graph.neighbors.data() + from, count}, neighbors.data());
    for (std::size_t i = 0; i < count; i += kAtOnce)
      renumber(neighbors.subspan(i, std::min<std::size_t>(kAtOnce, count - i)), run, kept);
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
  const std::uint32_t first = kept.empty() ? 0 : components.label[kept.vertex(0)];
  std::vector<std::uint32_t> labels;  // by label less the first
  Components part;
  part.label.resize(kept.size());
  for (const auto& run : kept.runs()) {
    std::uint32_t* const rows = part.label.data() + run.row;
    for_each_run(components, run.begin, run.end,
                 [&](std::uint32_t begin, std::uint32_t end, std::uint32_t c) {
                   if (labels.size() <= c - first) labels.resize(c - first + 1, kUnmet);
                   std::uint32_t& label = labels[c - first];
                   if (label == kUnmet) {
                     label = part.count++;
                     part.size.push_back(components.size[c]);
                   }
                   std::fill(rows + (begin - run.begin), rows + (end - run.begin), label);
                 });
  }
  return part;
}

/// What is compared at once is compared fast.
std::size_t run_length(std::span<const std::uint32_t> labels, std::size_t size) noexcept {
  const std::uint32_t* const first = labels.data();
  if (size <= labels.size() && std::equal(first + 1, first + size, first)) return size;
  return static_cast<std::size_t>(
      std::find_if(first, first + labels.size(), [&](std::uint32_t label) { return label != *first; }) -
      first);
}

}  // namespace deltamesh
