// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The fitting function between anchor density and low-frequency error (Yang, Li et al., section 4).
#pragma once

namespace deltamesh {

/// A measured pair: density v in edges, above 0, and LFE M_q in any one unit, above 0.
struct DensityPair {
  double density = 0;
  double lfe = 0;
};

/// The density v at which the LFE will be `lfe`, from two measured pairs at the same step of `bits` bits:
/// M = a v + b up to 5 bits, M = a e^(b v) from 7 bits, and in between the mean of the two answers, weighted
/// by the distance from 5 and 7 (alpha = 1/2 at 6 bits). The answer is clamped to 1 .. 65535. Pairs that do
/// not rise with v (equal densities, noise) are answered by proportion, M = a v, through the first.
double density_for_lfe(const DensityPair& first, const DensityPair& second, double bits, double lfe) noexcept;

}  // namespace deltamesh
