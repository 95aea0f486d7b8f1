// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The flags of a header, for both directions [HDR-5].
#pragma once

#include <algorithm>
#include <cstdint>

#include "base/short_float.h"
#include "format/header_fields.h"

namespace deltamesh {

/// What the fields of `h` take.
inline std::uint8_t flags_of(const FileHeader& h) noexcept {
  const Geometry geometry = geometry_of(h);
  const PositionLattice& lattice = h.predictive.lattice;
  unsigned flags = static_cast<unsigned>(geometry) << kGeometryShift;
  if (h.keeps_order) flags |= kFlagKeepsOrder;
  if (h.origin != std::array<double, 3>{}) flags |= kFlagOrigin;
  if ((geometry == Geometry::kHighpass ? h.highpass.bits : h.predictive.bits) != 0) flags |= kFlagBits;
  if (geometry == Geometry::kHighpass && !is_short_float(h.highpass.step)) flags |= kFlagLongSteps;
  if (!has_lattice(geometry)) return static_cast<std::uint8_t>(flags);
  if (!std::all_of(lattice.step.begin(), lattice.step.end(), is_short_float)) flags |= kFlagLongSteps;
  if (!has_one_step(lattice)) flags |= kFlagThreeSteps;
  if (lattice.origin != Vec3{}) flags |= kFlagLatticeOrigin;
  return static_cast<std::uint8_t>(flags);
}

/// Sets the members of `h` that the flags stand for.
inline void apply_flags(std::uint8_t flags, FileHeader& h) noexcept {
  const auto geometry = static_cast<Geometry>(flags >> kGeometryShift);
  h.keeps_order = (flags & kFlagKeepsOrder) != 0;
  h.geometry = geometry == Geometry::kHighpass ? kGeometryHighpass : kGeometryPredictive;
  if (geometry != Geometry::kHighpass)
    h.predictive.kind = static_cast<PositionKind>(static_cast<unsigned>(geometry) - 1);
}

/// Flags that mean nothing with the geometry.
inline bool are_reserved_flags_set(std::uint8_t flags) noexcept {
  constexpr unsigned kOfLattices = kFlagThreeSteps | kFlagLatticeOrigin;
  switch (static_cast<Geometry>(flags >> kGeometryShift)) {
    case Geometry::kHighpass:
      return (flags & kOfLattices) != 0;
    case Geometry::kFloats:
      return (flags & (kOfLattices | kFlagLongSteps)) != 0;
    case Geometry::kLattice:
    case Geometry::kVoxel:
      break;
  }
  return false;
}

}  // namespace deltamesh
