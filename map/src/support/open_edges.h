// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Edges that one face alone has.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace deltamesh {

class OpenEdges {
 public:
  /// `triangles`: m x 3 indices below `vertex_count`. O(m log d) for vertices of d edges.
  OpenEdges(std::span<const std::uint32_t> triangles, std::size_t vertex_count);

  /// The other ends of a vertex' open edges, ascending.
  std::span<const std::uint32_t> of(std::uint32_t vertex) const noexcept {
    return {ends_.data() + offsets_[vertex], ends_.data() + offsets_[vertex + 1]};
  }

 private:
  std::vector<std::uint32_t> offsets_;
  std::vector<std::uint32_t> ends_;
};

}  // namespace deltamesh
