// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Whether steps have come near enough to the least-squares solution.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "laplacian/settling/steps.h"
#include "topology/adjacency.h"

namespace deltamesh::settling {

/// At the solution, the functional is what quantisation left: about the same for every anchor. A component is
/// settled where what is still to come is a small share of that, and where the last proposal was taken at
/// about its own length: a step that is hardly taken is short wherever it starts from.
class Convergence {
 public:
  /// `components` must outlive this.
  Convergence(const Components& components, std::span<const std::uint32_t> anchors);

  /// After a step: whether that holds of all components. O(components).
  bool see(std::span<const Progress> progress);

  /// In components of which it did not hold after the last step. O(components).
  std::size_t unsettled_vertices() const noexcept;

  /// Per component 1 where it did not hold after the last step, and what is to come is not tolerable either,
  /// else 0.
  std::vector<std::uint8_t> unsettled(bool tolerantly) const;

 private:
  const Components& components_;
  std::vector<std::uint32_t> anchors_;  ///< per component: how many
  std::uint32_t anchor_count_;
  std::vector<double> last_;    ///< per component: size of the step before
  std::vector<double> excess_;  ///< per component: what is to come over what is allowed
};

}  // namespace deltamesh::settling
