// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The corners of a mesh by the edges that begin at them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace deltamesh {

/// Corner i of the triangles stands for the edge to the next corner of its face.
struct EdgeCorner {
  std::uint32_t high = 0;  ///< the edge's higher vertex
  std::uint32_t corner = 0;

  auto operator<=>(const EdgeCorner&) const = default;
};

class EdgeCorners {
 public:
  /// `triangles`: m x 3 indices below `vertex_count`. O(m log d) for vertices of d edges.
  EdgeCorners(std::span<const std::uint32_t> triangles, std::size_t vertex_count)
      : offsets_(vertex_count + 1, 0), corners_(triangles.size()) {
    const auto ends = [&](std::size_t i) {
      const std::uint32_t a = triangles[i];
      const std::uint32_t b = triangles[i % 3 == 2 ? i - 2 : i + 1];
      return std::array{std::min(a, b), std::max(a, b)};
    };
    for (std::size_t i = 0; i < triangles.size(); ++i) ++offsets_[ends(i)[0] + 1];
    for (std::size_t v = 0; v < vertex_count; ++v) offsets_[v + 1] += offsets_[v];
    std::vector<std::uint32_t> next(offsets_.begin(), offsets_.end() - 1);
    for (std::uint32_t i = 0; i < triangles.size(); ++i) corners_[next[ends(i)[0]]++] = {ends(i)[1], i};
    for (std::size_t v = 0; v < vertex_count; ++v)
      std::sort(corners_.begin() + offsets_[v], corners_.begin() + offsets_[v + 1]);
  }

  std::size_t vertex_count() const noexcept { return offsets_.size() - 1; }

  /// The corners of all edges whose lower vertex is `vertex`, ascending.
  std::span<const EdgeCorner> of(std::size_t vertex) const noexcept {
    return std::span(corners_).subspan(offsets_[vertex], offsets_[vertex + 1] - offsets_[vertex]);
  }

 private:
  std::vector<std::uint32_t> offsets_;
  std::vector<EdgeCorner> corners_;
};

}  // namespace deltamesh
