// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The fields before a part's chunks, once for both directions [MAP-7].
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "format/header_fields.h"
#include "part/container.h"

namespace deltamesh {

// Bits of the flags that streams use otherwise [MAP-7].
inline constexpr std::uint8_t kFlagPrimer = kFlagKeepsOrder;  ///< the part is a primer
inline constexpr std::uint8_t kFlagGrid = kFlagOrigin;        ///< the voxels are those of the map's grid
inline constexpr std::uint8_t kFlagPatched = kFlagBits;       ///< a base and a patch follow [MAP-17]

/// The expected `first` of a lattice with `step` and `origin`: the point at the lowest corner of the part's
/// cell.
inline std::int64_t first_of_cell(const PartPlace& place, std::size_t axis, double origin,
                                  double step) noexcept {
  const std::array<std::int32_t, 3> cell{place.key.x, place.key.y, place.key.z};
  const MapDescription& map = place.description;
  const double edge = std::ldexp(map.cell_steps * map.lattice.step(), place.key.level);
  const double corner = map.cell_origin[axis] * map.lattice.step() + cell[axis] * edge;
  const double steps = std::floor((corner - origin) / step);
  return std::abs(steps) <= static_cast<double>(kMostFirst) ? static_cast<std::int64_t>(steps) : 0;
}

/// As kMostFirst has it, where that leaves room for a sum.
inline bool can_add(std::int64_t first) noexcept {
  return first >= -2 * kMostFirst && first <= 2 * kMostFirst;
}

/// Steps, origin, first points from where the cell begins, and cells.
template <class Visitor, class Lattice>
void visit_part_lattice(Visitor& visit, std::uint8_t flags, const PartPlace& place, Lattice& lattice) {
  PositionLattice relative = lattice;
  const auto first = [&](std::size_t axis) {
    return first_of_cell(place, axis, relative.origin[axis], relative.step[axis]);
  };
  if constexpr (std::is_const_v<Lattice>) {
    for (std::size_t axis = 0; axis < 3; ++axis) relative.first[axis] -= first(axis);
    return visit_lattice(visit, flags, std::as_const(relative));
  } else {
    visit_lattice(visit, flags, relative);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (can_add(relative.first[axis])) relative.first[axis] += first(axis);  // else beyond [HDR-14]
    lattice = relative;
  }
}

/// The lattice of `levels` on `grid`, but for where it begins and ends.
inline PositionLattice lattice_on_grid(const VoxelGrid& grid, std::uint32_t levels) noexcept {
  PositionLattice lattice{.origin = grid.origin};
  for (std::size_t axis = 0; axis < 3; ++axis) lattice.step[axis] = grid.edge[axis] / (2.0 * levels);
  return lattice;
}

/// Levels, first nodes from where the cell begins, and nodes.
template <class Visitor, class Parameters>
void visit_on_grid(Visitor& visit, const PartPlace& place, Parameters& p) {
  visit.varint(p.levels);
  const std::uint32_t levels = std::clamp<std::uint32_t>(p.levels, 1, kMostLevels);  // else beyond [HDR-14]
  const std::int64_t voxel = 2 * std::int64_t{levels};
  PositionLattice lattice = lattice_on_grid(*place.description.grid, levels);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t before =
        first_of_cell(place, axis, lattice.origin[axis], static_cast<double>(voxel) * lattice.step[axis]);
    std::int64_t first = p.lattice.first[axis] / voxel - before;
    std::uint32_t nodes = static_cast<std::uint32_t>(p.lattice.cells[axis] / voxel);
    visit.varint(first);
    visit.varint(nodes);
    lattice.first[axis] =
        can_add(first) ? std::clamp((first + before), -2 * kMostFirst / voxel, 2 * kMostFirst / voxel) * voxel
                       : 2 * kMostFirst;
    lattice.cells[axis] = static_cast<std::uint32_t>(std::min<std::uint64_t>(
        std::uint64_t{nodes} * static_cast<std::uint64_t>(voxel), 2 * std::uint64_t{kMostCells}));
  }
  if constexpr (!std::is_const_v<Parameters>) p.lattice = lattice;
}

/// Whether visit_on_grid() says all of the lattice.
inline bool is_on_grid(const PartPlace& place, const FileHeader& h) noexcept {
  if (!place.description.grid || geometry_of(h) != Geometry::kVoxel) return false;
  const PositionLattice& lattice = h.predictive.lattice;
  const PositionLattice given = lattice_on_grid(*place.description.grid, h.predictive.levels);
  const std::int64_t voxel = 2 * std::int64_t{h.predictive.levels};
  bool is_on = lattice.origin == given.origin && lattice.step == given.step;
  for (std::size_t axis = 0; axis < 3; ++axis)
    is_on = is_on && lattice.first[axis] % voxel == 0 && lattice.cells[axis] % voxel == 0;
  return is_on;
}

/// Every field after the flags.
template <class Visitor, class Header>
void visit_part_header(Visitor& visit, std::uint8_t flags, const PartPlace& place, Header& h) {
  const Geometry geometry = geometry_of(h);
  visit_counts(visit, h);
  if (!has_lattice(geometry)) visit_box(visit, h);
  if ((flags & kFlagGrid) != 0) return visit_on_grid(visit, place, h.predictive);
  if (geometry == Geometry::kHighpass) return visit_highpass(visit, flags, h.highpass);
  if (has_lattice(geometry)) visit_part_lattice(visit, flags, place, h.predictive.lattice);
  if (geometry == Geometry::kVoxel) visit.varint(h.predictive.levels);
}

}  // namespace deltamesh
