// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Conjugate gradients for the coarsest level [DELT-7].
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/memory/large_vector.h"
#include "laplacian/multigrid/level/level.h"
#include "laplacian/multigrid/level/row.h"

namespace deltamesh::multigrid {

/// For N = K M^-1 K + E E^T, preconditioned by symmetric Gauss-Seidel, without forming the matrix. With the
/// roots of its diagonal S, the matrix S^-1 N S^-1 is B^T B + S^-2 E E^T = L + I + L^T with
/// B = M^-1/2 K S^-1. Solutions with I + L and I + L^T need B and an image under B only [Bjoerck, Elfving,
/// Accelerated projection methods, 1979]; two of them make an iteration, for y = (I + L)^-1 r in place of the
/// residual r and (I + L^T) d beside the direction d [Eisenstat, Efficient implementation of a class of
/// preconditioned conjugate gradient methods, 1981].
class ConjugateGradients {
 public:
  /// `components`: of each of at least one node the one that it belongs to, whose steps have lengths of their
  /// own then. Empty: all have the same [DELT-7].
  ConjugateGradients(const Level& level, std::span<const double> inverse_mass,
                     std::vector<std::uint32_t> components);

  /// `x`: n, the right-hand side, overwritten with what a fixed number of iterations from 0 finds. All axes
  /// at once, each by itself. O(n + edges).
  void solve(std::span<Double4> x);

 private:
  struct Node {
    std::uint32_t first;  ///< of its column of B; the last is the one before the next node's first
    double anchor;        ///< 1 over the diagonal of N, or 0 where it is none
    double scale;         ///< 1 over the root of the diagonal
  };
  struct Entry {
    std::uint32_t row;
    double value;
  };

  void add_node(const Level& level, std::span<const double> inverse_mass, double anchor, std::uint32_t node);
  std::span<const Entry> column(std::size_t i) const noexcept;
  Double4 row_of_image(std::size_t i) const noexcept;
  void add_to_image(std::size_t i, const Double4& z) noexcept;
  using Sums = std::vector<Double4>;  ///< per component
  void begin(std::span<Double4> x, Sums& energy);
  void turn(const Sums& share);
  void multiply(Sums& energy);
  void step(const Sums& length, std::span<Double4> x, Sums& energy);

  std::vector<std::uint32_t> components_;  ///< n; all 0 where steps have one length
  std::uint32_t component_count_ = 0;
  std::vector<Node> nodes_;  ///< and one for the end
  LargeVector<Entry> entries_;
  LargeVector<Double4> residual_;            ///< y
  LargeVector<Double4> direction_, turned_;  ///< d and (I + L^T) d
  LargeVector<Double4> product_;             ///< (I + L)^-1 A d
  LargeVector<Double4> image_;               ///< B times what the nodes come to so far have
};

}  // namespace deltamesh::multigrid
