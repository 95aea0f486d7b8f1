// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "geometry/delta_quantizer.h"

#include <algorithm>

namespace deltamesh {
namespace {

/// 1/256 steps.
constexpr double kMostShift = 127;

std::int8_t mean_shift(double sum, double count) noexcept {
  if (!(count > 0)) return 0;
  return static_cast<std::int8_t>(std::clamp(std::round(256 * sum / count), -kMostShift, kMostShift));
}

}  // namespace

BinErrors::BinErrors(const DeltaQuantizer& quantizer, std::span<const Vec3> deltas) noexcept
    : step_(quantizer.step) {
  const double inverse = 1 / quantizer.step;
  for (const Vec3& delta : deltas) {
    for (const double x : delta) {
      const double steps = std::abs(x) * inverse;
      const double symbol = std::abs(quantizer.symbol(x));
      Bin& bin = bins_[static_cast<std::size_t>(std::min(symbol, 2.0))];
      const double excess = symbol - steps;
      bin.sum += excess;
      bin.squares += excess * excess;
      bin.count += 1;
      largest_ = std::max(largest_, symbol);
    }
  }
}

ReconstructionShift BinErrors::centroids() const noexcept {
  return {.one = mean_shift(bins_[1].sum, bins_[1].count), .more = mean_shift(bins_[2].sum, bins_[2].count)};
}

double BinErrors::squares(const ReconstructionShift& shift) const noexcept {
  const std::array<double, 3> shifts = {0, shift.one / 256.0, shift.more / 256.0};
  double sum = 0;
  for (std::size_t i = 0; i < bins_.size(); ++i)
    sum += bins_[i].squares - 2 * shifts[i] * bins_[i].sum + shifts[i] * shifts[i] * bins_[i].count;
  return std::max(sum, 0.0) * step_ * step_;
}

}  // namespace deltamesh
