// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/anchors.h"

#include <algorithm>
#include <limits>
#include <queue>

namespace deltamesh {
namespace {

constexpr std::uint32_t kUnreached = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint32_t kVerticesPerAnchor = 200;

/// Hop distance of every vertex to the nearest anchor so far.
class HopDistances {
 public:
  explicit HopDistances(const Adjacency& graph) : graph_(graph), hops_(graph.vertex_count(), kUnreached) {}

  std::uint32_t operator[](std::uint32_t vertex) const noexcept { return hops_[vertex]; }

  /// Makes `vertex` an anchor.
  void add_anchor(std::uint32_t vertex) {
    hops_[vertex] = 0;
    queue_.assign(1, vertex);
    for (std::size_t head = 0; head < queue_.size(); ++head) {
      const std::uint32_t next = hops_[queue_[head]] + 1;
      for (const std::uint32_t neighbor : graph_.of(queue_[head])) {
        if (hops_[neighbor] <= next) continue;
        hops_[neighbor] = next;
        queue_.push_back(neighbor);
      }
    }
  }

  /// Makes the vertex farthest from `vertex` the first anchor of their component, and returns it: a vertex at
  /// the rim.
  std::uint32_t add_first_anchor(std::uint32_t vertex) {
    add_anchor(vertex);
    const auto is_nearer = [this](std::uint32_t a, std::uint32_t b) {
      return hops_[a] != hops_[b] ? hops_[a] < hops_[b] : a > b;
    };
    const std::uint32_t farthest = *std::max_element(queue_.begin(), queue_.end(), is_nearer);
    for (const std::uint32_t reached : queue_) hops_[reached] = kUnreached;
    add_anchor(farthest);
    return farthest;
  }

 private:
  const Adjacency& graph_;
  std::vector<std::uint32_t> hops_;
  std::vector<std::uint32_t> queue_;
};

/// The vertex farthest from all anchors, lowest index among equals. Distances only fall, so an entry may be
/// out of date in one direction alone: it is put back with its true distance when it comes to the top.
class FarthestFirst {
 public:
  FarthestFirst(const HopDistances& hops, std::vector<std::uint32_t> vertices) : hops_(hops) {
    std::vector<Entry> entries;
    entries.reserve(vertices.size());
    for (const std::uint32_t vertex : vertices) entries.push_back({hops[vertex], ~vertex});
    queue_ = std::priority_queue<Entry>({}, std::move(entries));
  }

  bool empty() const noexcept { return queue_.empty(); }

  std::uint32_t top() {
    for (;;) {
      const Entry entry = queue_.top();
      const std::uint32_t now = hops_[~entry.second];
      if (now == entry.first) return ~entry.second;
      queue_.pop();
      queue_.push({now, entry.second});
    }
  }

 private:
  using Entry = std::pair<std::uint32_t, std::uint32_t>;  // hops, complement of the vertex
  const HopDistances& hops_;
  std::priority_queue<Entry> queue_;
};

std::uint32_t wanted_count(const AnchorRequest& request, std::size_t solved_vertices) {
  if (request.density) return 0;
  if (request.count) return *request.count;
  return static_cast<std::uint32_t>((solved_vertices + kVerticesPerAnchor - 1) / kVerticesPerAnchor);
}

}  // namespace

Anchors place_anchors(const Adjacency& graph, const Components& components, const AnchorRequest& request) {
  Anchors anchors;
  HopDistances hops(graph);
  std::vector<std::uint32_t> solved;
  std::uint64_t count = 0;
  for (std::uint32_t vertex = 0; vertex < graph.vertex_count(); ++vertex) {
    const bool small = components.size[components.label[vertex]] < kSmallestSolvedComponent;
    if (!small) solved.push_back(vertex);
    if (small) {
      anchors.vertices.push_back(vertex);
    } else if (hops[vertex] == kUnreached) {
      anchors.vertices.push_back(hops.add_first_anchor(vertex));
      ++count;
    }
  }

  const std::uint32_t wanted = wanted_count(request, solved.size());
  FarthestFirst farthest(hops, std::move(solved));
  while (!farthest.empty()) {
    const std::uint32_t vertex = farthest.top();
    anchors.density = hops[vertex];
    const bool enough = request.density ? anchors.density <= *request.density : count >= wanted;
    if (enough || anchors.density == 0) break;
    anchors.vertices.push_back(vertex);
    hops.add_anchor(vertex);
    ++count;
  }
  std::sort(anchors.vertices.begin(), anchors.vertices.end());
  return anchors;
}

}  // namespace deltamesh
