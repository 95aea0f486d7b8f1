// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/lfe_fit.h"

#include <algorithm>

#include "base/numbers/portable_math.h"

namespace deltamesh {
namespace {

constexpr double kLinearBits = 5;       // and fewer
constexpr double kExponentialBits = 7;  // and more
constexpr double kLargestDensity = 65535;

/// v where the line through (x, first) and (x, second) reaches `y`.
double line_at(double v1, double y1, double v2, double y2, double y) noexcept {
  return v1 + (v2 - v1) * (y - y1) / (y2 - y1);
}

}  // namespace

double density_for_lfe(const DensityPair& first, const DensityPair& second, double bits,
                       double lfe) noexcept {
  const bool rises = (first.density - second.density) * (first.lfe - second.lfe) > 0;
  if (!rises) return std::clamp(first.density * lfe / first.lfe, 1.0, kLargestDensity);
  const double linear = line_at(first.density, first.lfe, second.density, second.lfe, lfe);
  const double exponential = line_at(first.density, portable_log2(first.lfe), second.density,
                                     portable_log2(second.lfe), portable_log2(lfe));
  const double alpha = std::clamp((kExponentialBits - bits) / (kExponentialBits - kLinearBits), 0.0, 1.0);
  return std::clamp(alpha * linear + (1 - alpha) * exponential, 1.0, kLargestDensity);
}

}  // namespace deltamesh
