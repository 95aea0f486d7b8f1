// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The numbers that vertices of a mesh get as a writer of CONN meets them.
#pragma once

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "connectivity/faces/cut.h"
#include "topology/vertex_runs.h"

namespace deltamesh {

/// Vertices of the mesh as their manifold vertices appear; later manifold vertices of a vertex are glued
/// [CONN-11].
class VertexNumbers {
 public:
  explicit VertexNumbers(std::uint32_t vertex_count) : has_(vertex_count, 0) { order_.reserve(vertex_count); }

  bool has(std::uint32_t vertex) const noexcept { return has_[vertex] != 0; }

  /// The vertices to come are of the next component of manifold vertices.
  void start() { runs_.begin(static_cast<std::uint32_t>(order_.size())); }

  /// The next manifold vertex is one of `vertex`.
  void add(std::uint32_t vertex) {
    if (has(vertex)) {
      if (coded_.empty()) number_vertices();
      coded_.push_back(number_[vertex]);
      runs_.join(number_[vertex]);
      return;
    }
    has_[vertex] = 1;
    if (!coded_.empty()) {
      number_[vertex] = static_cast<std::uint32_t>(order_.size());
      coded_.push_back(number_[vertex]);
    }
    order_.push_back(vertex);
  }

  /// Number of every manifold vertex, or nothing where none is glued, so that each is its own.
  const std::vector<std::uint32_t>& coded() const noexcept { return coded_; }

  /// Components of the mesh: those of manifold vertices, of which glued ones are the same, and vertices that
  /// were never added. Before take_order().
  std::uint32_t count_components() {
    runs_.end(static_cast<std::uint32_t>(order_.size()));
    return runs_.count(static_cast<std::uint32_t>(has_.size()));
  }

  /// Vertices by number; those that were never added come last, ascending.
  std::vector<std::uint32_t> take_order() {
    if (order_.size() < has_.size()) {
      for (std::uint32_t v = 0; v < has_.size(); ++v) {
        if (!has(v)) order_.push_back(v);
      }
    }
    return std::move(order_);
  }

 private:
  /// Numbers matter from the first glued vertex on.
  void number_vertices() {
    number_.resize(has_.size(), kNoIndex);
    for (std::uint32_t i = 0; i < order_.size(); ++i) number_[order_[i]] = i;
    coded_.resize(order_.size());
    std::iota(coded_.begin(), coded_.end(), 0U);
  }

  std::vector<std::uint8_t> has_;
  std::vector<std::uint32_t> number_;  ///< of every vertex, once one is glued
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> coded_;
  VertexRuns runs_;  ///< of vertices whose manifold vertices hang together
};

}  // namespace deltamesh
