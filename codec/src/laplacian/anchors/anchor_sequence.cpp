// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/anchors/anchor_sequence.h"

#include <xxhash.h>

#include <algorithm>
#include <limits>

namespace deltamesh {
namespace {

constexpr std::uint32_t kUnreached = std::numeric_limits<std::uint32_t>::max();

std::uint64_t fingerprint_of(const Adjacency& graph) noexcept {
  const std::uint64_t offsets =
      XXH3_64bits(graph.offsets.data(), graph.offsets.size() * sizeof(std::uint32_t));
  return XXH3_64bits_withSeed(graph.neighbors.data(), graph.neighbors.size() * sizeof(std::uint32_t),
                              offsets);
}

}  // namespace

AnchorSequence::AnchorSequence(const Adjacency& graph, const Components& components)
    : hops_(graph.vertex_count(), kUnreached) {
  std::vector<std::uint32_t> solved;
  for (std::uint32_t vertex = 0; vertex < graph.vertex_count(); ++vertex) {
    if (components.size[components.label[vertex]] < kSmallestSolvedComponent) {
      small_.push_back(vertex);
      continue;
    }
    solved.push_back(vertex);
    if (hops_[vertex] == kUnreached) add_first_anchor(graph, vertex);
  }
  fewest_ = static_cast<std::uint32_t>(anchors_.size());
  most_ = static_cast<std::uint32_t>(solved.size());
  std::vector<Entry> entries;
  entries.reserve(solved.size());
  for (const std::uint32_t vertex : solved) entries.push_back({hops_[vertex], ~vertex});
  by_hops_ = std::priority_queue<Entry>({}, std::move(entries));
}

void AnchorSequence::add_anchor(const Adjacency& graph, std::uint32_t vertex) {
  ++searches_;
  hops_[vertex] = 0;
  queue_.assign(1, vertex);
  for (std::size_t head = 0; head < queue_.size(); ++head) {
    const std::uint32_t next = hops_[queue_[head]] + 1;
    for (const std::uint32_t neighbor : graph.of(queue_[head])) {
      if (hops_[neighbor] <= next) continue;
      hops_[neighbor] = next;
      queue_.push_back(neighbor);
    }
  }
}

/// Takes the vertex farthest from `vertex` in their component: one at the rim.
void AnchorSequence::add_first_anchor(const Adjacency& graph, std::uint32_t vertex) {
  add_anchor(graph, vertex);
  const auto is_nearer = [this](std::uint32_t a, std::uint32_t b) {
    return hops_[a] != hops_[b] ? hops_[a] < hops_[b] : a > b;
  };
  const std::uint32_t rim = *std::max_element(queue_.begin(), queue_.end(), is_nearer);
  for (const std::uint32_t reached : queue_) hops_[reached] = kUnreached;
  add_anchor(graph, rim);
  anchors_.push_back(rim);
}

/// The vertex farthest from all anchors. An entry that is out of date is put back with its true distance when
/// it comes to the top. Precondition: there are solved vertices.
std::uint32_t AnchorSequence::farthest() {
  for (;;) {
    const Entry entry = by_hops_.top();
    const std::uint32_t now = hops_[~entry.second];
    if (now == entry.first) return ~entry.second;
    by_hops_.pop();
    by_hops_.push({now, entry.second});
  }
}

void AnchorSequence::grow(const Adjacency& graph, std::uint32_t count) {
  while (anchors_.size() < std::min(count, most_)) {
    const std::uint32_t vertex = farthest();
    depths_.push_back(hops_[vertex]);
    add_anchor(graph, vertex);
    anchors_.push_back(vertex);
  }
}

std::uint32_t AnchorSequence::density(const Adjacency& graph, std::uint32_t count) {
  const std::uint32_t clamped = std::clamp(count, fewest_, most_);
  grow(graph, clamped);
  if (clamped - fewest_ < depths_.size()) return depths_[clamped - fewest_];
  return by_hops_.empty() ? 0 : hops_[farthest()];
}

std::uint32_t AnchorSequence::count_for_density(const Adjacency& graph, std::uint32_t density) {
  // Depths never grow along the sequence.
  const auto closed =
      std::partition_point(depths_.begin(), depths_.end(), [density](auto depth) { return depth > density; });
  if (closed != depths_.end()) return fewest_ + static_cast<std::uint32_t>(closed - depths_.begin());
  while (!by_hops_.empty() && hops_[farthest()] > density)
    grow(graph, static_cast<std::uint32_t>(anchors_.size()) + 1);
  return static_cast<std::uint32_t>(anchors_.size());
}

Anchors AnchorSequence::first(const Adjacency& graph, std::uint32_t count) {
  const std::uint32_t clamped = std::clamp(count, fewest_, most_);
  Anchors anchors;
  anchors.density = density(graph, clamped);
  anchors.vertices = small_;
  anchors.vertices.insert(anchors.vertices.end(), anchors_.begin(), anchors_.begin() + clamped);
  std::sort(anchors.vertices.begin(), anchors.vertices.end());
  return anchors;
}

AnchorSequence& AnchorContainers::Impl::sequence(const Adjacency& graph, const Components& components) {
  const std::uint64_t fingerprint = fingerprint_of(graph);
  if (!sequence_ || fingerprint != fingerprint_) {
    sequence_.emplace(graph, components);
    fingerprint_ = fingerprint;
  }
  return *sequence_;
}

AnchorContainers::AnchorContainers() : impl_(std::make_unique<Impl>()) {}
AnchorContainers::~AnchorContainers() = default;
std::uint64_t AnchorContainers::searches() const noexcept { return impl_->searches(); }

std::uint32_t hop_density(const Adjacency& graph, std::span<const std::uint32_t> anchors) {
  std::vector<std::uint8_t> reached(graph.vertex_count(), 0);
  std::vector<std::uint32_t> ring(anchors.begin(), anchors.end());
  for (const std::uint32_t anchor : ring) reached[anchor] = 1;
  std::vector<std::uint32_t> next;
  for (std::uint32_t hops = 0;; ++hops) {
    next.clear();
    for (const std::uint32_t vertex : ring) {
      for (const std::uint32_t neighbor : graph.of(vertex)) {
        if (reached[neighbor] != 0) continue;
        reached[neighbor] = 1;
        next.push_back(neighbor);
      }
    }
    if (next.empty()) return hops;
    ring.swap(next);
  }
}

}  // namespace deltamesh
