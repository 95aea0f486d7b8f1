// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The fields before a part's chunks, once for both directions [MAP-7].
#pragma once

#include <cmath>

#include "base/try.h"
#include "format/header_fields.h"
#include "part_container.h"

namespace deltamesh {

/// Where a lattice is expected to begin, in its steps: at the lowest corner of the part's cell.
inline std::array<std::int64_t, 3> first_of_cell(const PartPlace& place,
                                                 const PositionLattice& lattice) noexcept {
  const double edge =
      std::ldexp(place.description.cell_steps * place.description.lattice.step(), place.key.level);
  const std::array<double, 3> corner{place.key.x * edge, place.key.y * edge, place.key.z * edge};
  std::array<std::int64_t, 3> first{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double steps = std::floor((corner[axis] - lattice.origin[axis]) / lattice.step[axis]);
    if (std::abs(steps) <= static_cast<double>(kMostFirst)) first[axis] = static_cast<std::int64_t>(steps);
  }
  return first;
}

/// Steps, origin, first points from where the cell begins, and cells.
template <class Visitor, class Lattice>
Result<void> visit_part_lattice(const Visitor& visit, std::uint8_t flags, const PartPlace& place,
                                Lattice& lattice) {
  if constexpr (std::is_const_v<Lattice>) {
    PositionLattice relative = lattice;
    const auto first = first_of_cell(place, lattice);
    for (std::size_t axis = 0; axis < 3; ++axis) relative.first[axis] -= first[axis];
    return visit_lattice(visit, flags, std::as_const(relative));
  } else {
    DELTAMESH_CHECK(visit_lattice(visit, flags, lattice));
    const auto first = first_of_cell(place, lattice);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      // What is out of range stays so [HDR-14].
      if (lattice.first[axis] >= -2 * kMostFirst && lattice.first[axis] <= 2 * kMostFirst)
        lattice.first[axis] += first[axis];
    }
    return {};
  }
}

/// Every field after the flags.
template <class Visitor, class Header>
Result<void> visit_part_header(const Visitor& visit, std::uint8_t flags, const PartPlace& place, Header& h) {
  const Geometry geometry = geometry_of(h);
  DELTAMESH_CHECK(visit_counts(visit, h));
  if (!has_lattice(geometry)) DELTAMESH_CHECK(visit_box(visit, h));
  if (geometry == Geometry::kHighpass) return visit_highpass(visit, flags, h.highpass);
  if (has_lattice(geometry)) DELTAMESH_CHECK(visit_part_lattice(visit, flags, place, h.predictive.lattice));
  return geometry == Geometry::kVoxel ? visit.varint(h.predictive.levels) : Result<void>();
}

}  // namespace deltamesh
