// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "measure/error_peaks.h"

#include <algorithm>

namespace deltamesh {
namespace {

constexpr int kApart = 3;  // edges

/// Marks every vertex at most kApart edges from `peak`.
void mark_around(const Adjacency& graph, std::uint32_t peak, std::vector<std::uint8_t>& taken) {
  std::vector<std::uint32_t> ring{peak};
  std::vector<std::uint32_t> next;
  taken[peak] = 1;
  for (int hops = 0; hops < kApart; ++hops) {
    next.clear();
    for (const std::uint32_t vertex : ring) {
      for (const std::uint32_t neighbor : graph.of(vertex)) {
        taken[neighbor] = 1;
        next.push_back(neighbor);
      }
    }
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    ring.swap(next);
  }
}

}  // namespace

std::vector<std::uint32_t> error_peaks(const Adjacency& graph, std::span<const double> errors,
                                       std::span<const std::uint8_t> excluded, double threshold,
                                       std::size_t count) {
  std::vector<std::uint32_t> candidates;
  for (std::uint32_t v = 0; v < errors.size(); ++v)
    if (errors[v] > threshold && excluded[v] == 0) candidates.push_back(v);
  std::sort(candidates.begin(), candidates.end(), [errors](std::uint32_t a, std::uint32_t b) {
    return errors[a] != errors[b] ? errors[a] > errors[b] : a < b;
  });
  std::vector<std::uint8_t> taken(errors.size(), 0);
  std::vector<std::uint32_t> peaks;
  for (const std::uint32_t v : candidates) {
    if (peaks.size() >= count) break;
    if (taken[v] != 0) continue;
    peaks.push_back(v);
    mark_around(graph, v, taken);
  }
  return peaks;
}

}  // namespace deltamesh
