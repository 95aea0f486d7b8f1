// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "lattice/border_table.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace deltamesh {

PositionBits bits_of(const Mesh& mesh, std::size_t vertex) noexcept {
  const float* p = mesh.positions.data() + 3 * vertex;
  return {std::bit_cast<std::uint32_t>(p[0]), std::bit_cast<std::uint32_t>(p[1]),
          std::bit_cast<std::uint32_t>(p[2])};
}

void BorderTable::add(const Mesh& mesh, std::uint32_t part) {
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const float* p = mesh.positions.data() + 3 * v;
    uses_.push_back({lattice_.nearest({p[0], p[1], p[2]}), bits_of(mesh, v), part, 0});
  }
}

std::vector<BorderUse> BorderTable::finish() {
  std::ranges::sort(uses_);
  const auto repeated = std::unique(uses_.begin(), uses_.end());
  uses_.erase(repeated, uses_.end());
  std::vector<BorderUse> border;
  LatticePoint point{};
  std::uint32_t twins = 0;
  for (auto first = uses_.begin(); first != uses_.end();) {
    const auto last = std::find_if(first, uses_.end(),
                                   [&](const BorderUse& use) { return use.position != first->position; });
    if (last - first > 1) {
      if (border.empty() || point != first->point) twins = 0;
      point = first->point;
      for (auto use = first; use != last; ++use) {
        use->twin = twins;
        border.push_back(*use);
      }
      ++twins;
    }
    first = last;
  }
  uses_.clear();
  return border;
}

std::vector<std::vector<BorderPosition>> borders_of_parts(std::span<const BorderUse> uses,
                                                          std::size_t count) {
  std::vector<std::vector<BorderPosition>> borders(count);
  for (const BorderUse& use : uses) borders[use.part].push_back({use.position, use.point, use.twin});
  for (auto& border : borders) std::ranges::sort(border);
  return borders;
}

}  // namespace deltamesh
