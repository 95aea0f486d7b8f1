// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Anchors in the order in which breadth-first farthest-point search finds them; every set of anchors that is
// ever asked for is a beginning of that sequence (Yang, Li et al., section 4, containers Delta_V).
#pragma once

#include <cstdint>
#include <optional>
#include <queue>
#include <span>
#include <vector>

#include "deltamesh/anchor_containers.h"
#include "laplacian/anchors/anchors.h"
#include "topology/adjacency.h"

namespace deltamesh {

/// Grows on demand and never searches twice. One anchor in every solved component, farthest from its lowest
/// vertex; then always the vertex that is farthest (in edges) from all anchors, the lowest index among
/// equals. The graph is passed anew to every call that may search, and must be the one of the constructor.
class AnchorSequence {
 public:
  AnchorSequence(const Adjacency& graph, const Components& components);

  std::uint32_t fewest() const noexcept { return fewest_; }  ///< solved components
  std::uint32_t most() const noexcept { return most_; }      ///< solved vertices
  std::uint64_t searches() const noexcept { return searches_; }

  /// Anchors of container `density`: so few that no solved vertex is more edges from one. At least fewest().
  std::uint32_t count_for_density(const Adjacency& graph, std::uint32_t density);

  /// Largest hop distance of a solved vertex to the nearest of the first `count` anchors, which is clamped to
  /// fewest() .. most().
  std::uint32_t density(const Adjacency& graph, std::uint32_t count);

  /// The first `count` anchors (clamped likewise) and every vertex of the small components, ascending.
  Anchors first(const Adjacency& graph, std::uint32_t count);

 private:
  using Entry = std::pair<std::uint32_t, std::uint32_t>;  // hops, complement of the vertex

  void add_anchor(const Adjacency& graph, std::uint32_t vertex);
  void add_first_anchor(const Adjacency& graph, std::uint32_t vertex);
  std::uint32_t farthest();
  void grow(const Adjacency& graph, std::uint32_t count);

  std::vector<std::uint32_t> small_;    ///< vertices of the small components
  std::vector<std::uint32_t> anchors_;  ///< of the solved components, in order of addition
  std::vector<std::uint32_t> depths_;   ///< largest hop distance before each anchor after the first ones
  std::vector<std::uint32_t> hops_;     ///< to the nearest anchor, per vertex of the graph
  std::vector<std::uint32_t> queue_;    ///< scratch of the search
  std::priority_queue<Entry> by_hops_;  ///< solved vertices; distances only fall, so entries may be stale
  std::uint32_t fewest_ = 0;
  std::uint32_t most_ = 0;
  std::uint64_t searches_ = 0;
};

/// The paper's v: largest hop distance of a vertex to the nearest of `anchors`; vertices that reach none are
/// left out. O(n + edges).
std::uint32_t hop_density(const Adjacency& graph, std::span<const std::uint32_t> anchors);

/// State of an AnchorContainers object: the sequence and the graph that it belongs to.
class AnchorContainers::Impl {
 public:
  /// The sequence for `graph`; a new one where the graph is another than last time. O(n + edges) to tell.
  AnchorSequence& sequence(const Adjacency& graph, const Components& components);
  std::uint64_t searches() const noexcept { return sequence_ ? sequence_->searches() : 0; }

 private:
  std::uint64_t fingerprint_ = 0;
  std::optional<AnchorSequence> sequence_;
};

}  // namespace deltamesh
