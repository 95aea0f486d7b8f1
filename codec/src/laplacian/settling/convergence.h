// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Whether steps have come near enough to the least-squares solution.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "laplacian/settling/steps.h"
#include "topology/adjacency.h"

namespace deltamesh::settling {

/// The convergence test of settling. At the solution the functional is the noise of quantisation, about the
/// same for every anchor. It gives the size of the deltas' errors, and the probe gives the errors of
/// positions that these cause: the expected errors. A component is settled when the estimated remaining
/// movement of x is a small share of its expected errors, or of their mean over all components. The estimate
/// extrapolates the sizes of the last steps of x or of the probe, whichever shrink more slowly: where
/// convergence is slow, x may have hardly moved yet.
class Convergence {
 public:
  /// `components` must outlive this; `anchors`: at least one in each; `noise`: upper limit of the expected
  /// square of a delta's error on one axis; `highest_rate`: upper limit of the ratio of a step's size to that
  /// of the step before.
  Convergence(const Components& components, std::span<const std::uint32_t> anchors, double noise,
              double highest_rate);

  /// Call after each step. True if all components are settled. O(components).
  bool see(std::span<const Progress> progress);

  /// Number of vertices in components that were not settled after the last step. O(components).
  std::size_t unsettled_vertices() const noexcept;

  /// Per component 1 if the estimated remaining movement after the last step is above `most` times the
  /// allowed one, else 0.
  std::vector<std::uint8_t> unsettled(double most) const;

 private:
  /// Sizes of the last steps, latest first.
  struct History {
    std::array<double, 4> sizes{};
    std::array<double, 4> probe_sizes{};

    double see(double size, double probe_size, double highest_rate) noexcept;
  };

  const Components& components_;
  double noise_;
  double highest_rate_;
  std::vector<double> anchors_;   ///< per component, how many
  std::vector<History> history_;  ///< per component
  std::vector<double> excess_;    ///< per component: what is to come over what is allowed
};

}  // namespace deltamesh::settling
