// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Conjugate gradients on (K M^-1 K + sum_a e_a e_a^T) x = b, for a level too large to be factored.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "laplacian/settling/level.h"
#include "laplacian/settling/row.h"

namespace deltamesh::settling {

/// What all nodes of a coarsest level have.
struct CoarsestNodes {
  const Level& level;
  std::span<const double> inverse_mass;     ///< n: 1 / M; 0 where M is 0
  std::span<const std::uint8_t> is_anchor;  ///< n
};

class ConjugateGradients {
 public:
  ConjugateGradients() = default;
  ConjugateGradients(const ConjugateGradients&) = delete;
  ConjugateGradients& operator=(const ConjugateGradients&) = delete;
  virtual ~ConjugateGradients() = default;

  /// `x`: n, the right-hand side; overwritten. Ends after `most_iterations` at the latest. Returns how many
  /// were made. O(iterations (n + edges)).
  virtual std::uint32_t solve(std::span<Double4> x, std::uint32_t most_iterations) = 0;
};

/// `nodes` have served when this returns. `reduction` of the residual, on every axis and as the
/// preconditioner measures it, ends the iterations. Where it is 1e-3 or more floats are enough, and half the
/// work.
std::unique_ptr<ConjugateGradients> make_conjugate_gradients(const CoarsestNodes& nodes, double reduction);

}  // namespace deltamesh::settling
