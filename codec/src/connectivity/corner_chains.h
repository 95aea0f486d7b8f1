// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The corners of the faces so far, vertex by vertex, the newest first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace deltamesh {

constexpr std::uint32_t next_corner(std::uint32_t corner) noexcept {
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}
constexpr std::uint32_t last_corner(std::uint32_t corner) noexcept {
  return corner % 3 == 0 ? corner + 2 : corner - 1;
}

/// Memory: 4 bytes per vertex and 12 per face.
class CornerChains {
 public:
  /// `triangles`: m x 3, must outlive this.
  CornerChains(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count)
      : triangles_(triangles), newest_(vertex_count, kNone), older_(triangles.size(), kNone) {}

  void add(std::uint32_t face) noexcept {
    for (std::uint32_t corner = 3 * face; corner < 3 * face + 3; ++corner) {
      older_[corner] = newest_[triangles_[corner]];
      newest_[triangles_[corner]] = corner;
    }
  }

  /// The newest corner at `from` whose face goes on to `to`, among the kMostSteps newest there.
  std::optional<std::uint32_t> find(std::uint32_t from, std::uint32_t to) const noexcept {
    std::uint32_t corner = newest_[from];
    for (unsigned step = 0; step < kMostSteps && corner != kNone; ++step) {
      if (triangles_[next_corner(corner)] == to) return corner;
      corner = older_[corner];
    }
    return std::nullopt;
  }

 private:
  static constexpr unsigned kMostSteps = 16;
  static constexpr std::uint32_t kNone = 0xffffffff;

  std::span<const std::uint32_t> triangles_;
  std::vector<std::uint32_t> newest_;  ///< per vertex
  std::vector<std::uint32_t> older_;   ///< per corner
};

}  // namespace deltamesh
