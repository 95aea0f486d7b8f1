// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Planes on which the coordinates of an axis pile up, and combs of such planes. Encoder only.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "positions/lattice/axis_values.h"

namespace deltamesh {

/// A value that many coordinates of an axis share but for rounding.
struct Plane {
  double place;
  std::size_t count;
};

/// `noise`: how far apart coordinates of one plane may be; `fewest`: coordinates that make a plane.
std::vector<Plane> find_planes(const AxisValues& coordinates, std::size_t axis, double noise,
                               std::size_t fewest);

/// The distance of neighbouring planes that `share` of them are below, made sharper by the mean of those near
/// it; 0 where there are too few planes.
double usual_distance(std::span<const Plane> planes, double share = 0.5);

/// Planes at equal distances.
struct PlaneComb {
  double origin;
  double distance;
};

/// Least squares of the planes that the comb meets within `tolerance` of its distance.
PlaneComb refine(std::span<const Plane> planes, const PlaneComb& comb, double tolerance);

}  // namespace deltamesh
