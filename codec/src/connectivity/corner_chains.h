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

#include "connectivity/cut.h"

namespace deltamesh {

/// Memory: 4 bytes per vertex and 12 per face.
class CornerChains {
 public:
  /// `triangles`: m x 3, must outlive this.
  CornerChains(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count)
      : triangles_(triangles), newest_(vertex_count, kNoIndex), older_(triangles.size(), kNoIndex) {}

  void add(std::uint32_t face) noexcept {
    for (std::uint32_t corner = 3 * face; corner < 3 * face + 3; ++corner) {
      older_[corner] = newest_[triangles_[corner]];
      newest_[triangles_[corner]] = corner;
    }
  }

  /// The newest corner at `from` whose face goes on to `to`, among the kMostSteps newest there.
  std::optional<std::uint32_t> find(std::uint32_t from, std::uint32_t to) const noexcept {
    std::uint32_t corner = newest_[from];
    for (unsigned step = 0; step < kMostSteps && corner != kNoIndex; ++step) {
      if (triangles_[next_in_face(corner)] == to) return corner;
      corner = older_[corner];
    }
    return std::nullopt;
  }

 private:
  static constexpr unsigned kMostSteps = 16;

  std::span<const std::uint32_t> triangles_;
  std::vector<std::uint32_t> newest_;  ///< per vertex
  std::vector<std::uint32_t> older_;   ///< per corner
};

}  // namespace deltamesh
