// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Two cycles on a coarse level, added up so that the level's least-squares functional is smallest.
#pragma once

#include <span>
#include <vector>

#include "base/large_vector.h"
#include "laplacian/settling/level.h"
#include "laplacian/settling/row.h"

namespace deltamesh::settling {

/// What a cycle on a level works on: K x + M s = b_x,  K s - E f = b_s,  x_a - f_a = g_a.
struct LevelProblem {
  const Level& level;
  std::span<Row> b;          ///< n; at anchors, b_s with the forces found so far added
  std::span<Row> u;          ///< n: x and s
  std::span<Float4> gaps;    ///< per anchor: g
  std::span<Float4> forces;  ///< per anchor: f
};

/// Conjugate residuals of length two (Notay, Vassilevski, Recursive Krylov-based multigrid cycles, 2008) in
/// the norm of the normal equations, (p, q) = (K p)^T M^-1 K q + sum_a p_a q_a, on every axis by itself:
/// between two cycles take_first() takes the first one's solution at its best length and leaves in `b` and
/// `gaps` what remains; after the second combine() gives the best sum of both. The functional cannot rise,
/// however bad the cycles.
class TwoSteps {
 public:
  /// `level`: not the finest.
  explicit TwoSteps(const Level& level);

  /// O(n + edges).
  void take_first(const LevelProblem& problem);
  void combine(const LevelProblem& problem);

 private:
  LargeVector<Row> first_;  ///< first cycle's solution
  LargeVector<Row> image_;  ///< K x + M s and K s of it
  std::vector<Float4> forces_;
  Double4 energy_;  ///< (first, first)
  Double4 length_;  ///< at which it is taken
};

}  // namespace deltamesh::settling
