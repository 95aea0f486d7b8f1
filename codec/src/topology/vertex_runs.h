// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Connected components without the graph, from runs of vertices that are known to be connected.
#pragma once

#include <cstdint>
#include <vector>

#include "topology/adjacency.h"

namespace deltamesh {

/// Runs of vertices, in order, without gaps. Each hangs together; some are joined.
class VertexRuns {
 public:
  /// The next run begins at `vertex`, where the one before ends. A run without vertices must be joined.
  void begin(std::uint32_t vertex);

  /// The last run and the one that has `vertex` hang together. O(log runs), amortised nearly.
  void join(std::uint32_t vertex);

  /// The last run ends before `vertex`; from there on each is on its own.
  void end(std::uint32_t vertex) noexcept { end_ = vertex; }

  /// The number of components among `vertices` vertices, as find_components() has it.
  std::uint32_t count(std::uint32_t vertices) const noexcept { return sets_ + (vertices - end_); }

  /// The components, as find_components() has them. O(vertices).
  Components components(std::uint32_t vertices) const;

 private:
  std::uint32_t set_of(std::uint32_t run) noexcept;

  std::vector<std::uint32_t> first_;   ///< vertex of every run
  std::vector<std::uint32_t> joined_;  ///< run before it that it is joined to, or itself
  std::uint32_t sets_ = 0;
  std::uint32_t end_ = 0;
};

}  // namespace deltamesh
