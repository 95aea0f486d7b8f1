// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The coordinates of a mesh's vertices, axis by axis and in order, and the grids that they are on. Encoder
// only.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/numbers/vec3.h"
#include "format/predictive_parameters.h"

namespace deltamesh {

/// Sorts an axis when first asked for it.
class AxisValues {
 public:
  /// `positions`: floats; they must outlive this. `most_sampled`: of more vertices, one in so many is looked
  /// at that at most this many are.
  explicit AxisValues(std::span<const Vec3> positions, std::size_t most_sampled = ~std::size_t{0}) noexcept
      : positions_(positions), stride_(positions.empty() ? 1 : 1 + (positions.size() - 1) / most_sampled) {}

  std::span<const Vec3> positions() const noexcept { return positions_; }
  /// One vertex in so many is in the sample, the first one among them.
  std::size_t stride() const noexcept { return stride_; }

  /// Whether some 2000 of an axis' values have equal ones. Without them there are no planes, and no need to
  /// sort them all.
  bool has_repeats(std::size_t axis) const;

  /// The number of neighbouring values, among some 2000, whose distance is above `least` and below `most`.
  std::size_t count_distances(std::size_t axis, double least, double most) const;

  /// The sample's values of an axis, ascending. O(n).
  std::span<const float> sorted(std::size_t axis) const;

 private:
  /// Some 2000 values, ascending; all where there are no more.
  const std::vector<float>& few(std::size_t axis) const;

  std::span<const Vec3> positions_;
  std::size_t stride_;
  mutable std::array<std::vector<float>, 3> few_;
  mutable std::array<std::vector<float>, 3> sorted_;
};

/// An axis whose coordinates are all whole steps from `origin`, but for rounding.
struct AxisGrid {
  double origin = 0;
  double step = 0;  ///< 0 where there is none
};

/// Fits a grid to each axis, by all vertices and not only the sample. `finest`: lower limit of the steps.
/// O(n).
std::array<AxisGrid, 3> fit_axes(const AxisValues& values, const Box& box, double finest = 0);

/// An axis keeps its grid in lattices up to this step; 0 without one. Beyond, it would be much finer than
/// they are.
constexpr double coarsest_step_on(const AxisGrid& grid) noexcept { return grid.step / 0.6; }

/// cubic_lattice(), but with the own steps of axes that have a grid not much finer.
PositionLattice grid_lattice(const Box& box, const std::array<AxisGrid, 3>& axes, double step) noexcept;

}  // namespace deltamesh
