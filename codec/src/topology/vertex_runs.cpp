// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "topology/vertex_runs.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace deltamesh {

void VertexRuns::begin(std::uint32_t vertex) {
  joined_.push_back(static_cast<std::uint32_t>(first_.size()));
  first_.push_back(vertex);
  ++sets_;
}

std::uint32_t VertexRuns::set_of(std::uint32_t run) noexcept {
  while (joined_[run] != run) run = joined_[run] = joined_[joined_[run]];
  return run;
}

void VertexRuns::join(std::uint32_t vertex) {
  if (vertex >= first_.back()) return;
  const auto after = std::upper_bound(first_.begin(), first_.end(), vertex);
  std::uint32_t a = set_of(static_cast<std::uint32_t>(after - first_.begin()) - 1);
  std::uint32_t b = set_of(static_cast<std::uint32_t>(first_.size()) - 1);
  if (a == b) return;
  if (a > b) std::swap(a, b);
  joined_[b] = a;
  --sets_;
}

/// Runs ascend, so that components are met in the order of their smallest vertices.
Components VertexRuns::components(std::uint32_t vertices) const {
  constexpr std::uint32_t kUnmet = 0xffffffff;
  std::vector<std::uint32_t> set = joined_;
  std::vector<std::uint32_t> label(first_.size(), kUnmet);
  Components components;
  components.label.resize(vertices);
  for (std::size_t run = 0; run < first_.size(); ++run) {
    set[run] = set[set[run]];
    const std::uint32_t begin = first_[run];
    const std::uint32_t end = run + 1 < first_.size() ? first_[run + 1] : end_;
    if (begin == end) continue;
    std::uint32_t& own = label[set[run]];
    if (own == kUnmet) {
      own = components.count++;
      components.size.push_back(0);
    }
    components.size[own] += end - begin;
    std::fill(components.label.begin() + begin, components.label.begin() + end, own);
  }
  for (std::uint32_t v = end_; v < vertices; ++v) components.label[v] = components.count++;
  components.size.resize(components.count, 1);
  return components;
}

}  // namespace deltamesh
