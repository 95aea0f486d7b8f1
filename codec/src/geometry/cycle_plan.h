// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What planned cycles may cost in quality beside those that settle [DELT-7].
#pragma once

#include <cstdint>
#include <span>

#include "base/vec3.h"
#include "laplacian/operator/solved_part.h"

namespace deltamesh {

/// Cycles that are tried before it is left to the decoder to decide.
inline constexpr int kMostPlanned = 8;

/// Quantised deltas of streams with planned cycles are smaller [DELT-7].
inline constexpr std::int32_t kLargestPlannedSymbol = 1 << 23;

/// Errors of a plan's positions over those of settled ones, where the solver decided itself when to stop: how
/// far they are from the true ones, rms and at most, and rms of the delta coordinates' errors, which is what
/// the eye sees.
struct PlanCost {
  double rms = 0;
  double largest = 0;
  double roughness = 0;

  /// Hardly more than 1 each.
  bool is_fair() const noexcept { return rms <= 1.019 && largest <= 1.02 && roughness <= 1.0125; }
  /// Whether other roundings of the same may be fair: the largest error is one vertex's.
  bool is_close() const noexcept { return rms <= 1.1 && roughness <= 1.03; }
};

class PlanJudge {
 public:
  /// `positions`, `settled`: n, of the whole graph. `part` and `positions` must outlive this. `invisible`:
  /// model units that nobody would see, which cost nothing. Over the rows of `part`, at least one.
  /// O(n + edges).
  PlanJudge(const SolvedPart& part, std::span<const Vec3> positions, std::span<const Vec3> settled,
            double invisible);

  /// `solution`: n. O(n + edges).
  PlanCost cost(std::span<const Vec3> solution) const;

 private:
  const SolvedPart& part_;
  std::span<const Vec3> positions_;
  double invisible_;
  PlanCost settled_;  ///< model units
};

}  // namespace deltamesh
