// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Tests whether a part is in a view.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "deltamesh/map/description.h"
#include "deltamesh/map/messages.h"

namespace deltamesh {

/// Low corner and edge of a part's cell, relative to the map's origin.
struct CellCube {
  std::array<double, 3> low{};
  double edge = 0;
};

inline CellCube cube_of(const PartKey& key, const MapDescription& description) noexcept {
  const double edge = std::ldexp(description.cell_steps * description.lattice.step(), key.level);
  const double step = description.lattice.step();
  const LatticePoint& origin = description.cell_origin;
  return {{origin[0] * step + key.x * edge, origin[1] * step + key.y * edge, origin[2] * step + key.z * edge},
          edge};
}

/// Squared, from the middle of the cell to the middle of the nearest box; 0 without boxes.
inline double way_to(const PartKey& key, const View& view, const MapDescription& description) noexcept {
  if (view.boxes.empty()) return 0;
  const CellCube cube = cube_of(key, description);
  double least = std::numeric_limits<double>::infinity();
  for (const ViewBox& box : view.boxes) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double way = cube.low[k] + cube.edge / 2 - (double{box.low[k]} + box.high[k]) / 2;
      sum += way * way;
    }
    least = std::min(least, sum);
  }
  return least;
}

/// Whether the part's cell touches a box of the view. The same in senders and receivers.
inline bool is_in_view(const PartKey& key, const View& view, const MapDescription& description) noexcept {
  if (key.level < view.level) return false;
  if (view.boxes.empty()) return true;
  const CellCube cube = cube_of(key, description);
  return std::ranges::any_of(view.boxes, [&](const ViewBox& box) {
    for (std::size_t k = 0; k < 3; ++k)
      if (box.low[k] > cube.low[k] + cube.edge || box.high[k] < cube.low[k]) return false;
    return true;
  });
}

}  // namespace deltamesh
