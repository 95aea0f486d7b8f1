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

/// At the solution, the functional is what quantisation left: about the same for every anchor. That tells how
/// large the errors of deltas are, and the probe how far these move positions: the errors to expect. A
/// component is settled when what x is estimated to move by still is a small share of the errors to expect
/// there, or of their mean over all components. The estimate follows from how fast steps become smaller:
/// those of x or of the probe, whichever do so more slowly, as x may have hardly moved yet where convergence
/// is slow.
class Convergence {
 public:
  /// `components` must outlive this; `anchors`: at least one in each; `noise`: square of a delta's error that
  /// is to be expected on one axis, at the most; `highest_rate`: what a step leaves of the size of the one
  /// before, at the worst.
  Convergence(const Components& components, std::span<const std::uint32_t> anchors, double noise,
              double highest_rate);

  /// After a step: whether that holds of all components. O(components).
  bool see(std::span<const Progress> progress);

  /// In components of which it did not hold after the last step. O(components).
  std::size_t unsettled_vertices() const noexcept;

  /// Per component 1 where more than so many times what is allowed was to come after the last step, else 0.
  std::vector<std::uint8_t> unsettled(double most) const;

 private:
  /// Sizes of the steps before, the last one first.
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
