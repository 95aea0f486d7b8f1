// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "highpass/delta_quantizer.h"

namespace deltamesh {
namespace {

/// 1/256 steps.
constexpr double kMostShift = 127;

std::int8_t mean_shift(double sum, double count) noexcept {
  if (!(count > 0)) return 0;
  return static_cast<std::int8_t>(std::clamp(std::round(256 * sum / count), -kMostShift, kMostShift));
}

}  // namespace

BinErrors::BinErrors(double step, std::span<const Vec3> deltas) noexcept : step_(step) {
  const DeltaQuantizer quantizer{.step = step};
  for (const Vec3& delta : deltas)
    for (const double x : delta) add(std::abs(quantizer.symbol(x)), std::abs(x) / step);
}

BinErrors::BinErrors(double step, std::span<const Vec3> deltas,
                     std::span<const std::int32_t> symbols) noexcept
    : step_(step) {
  for (std::size_t i = 0; i < deltas.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double symbol = symbols[axis * deltas.size() + i];
      const double steps = deltas[i][axis] / step;
      add(std::abs(symbol), symbol < 0 ? -steps : steps);
    }
  }
}

ReconstructionShift BinErrors::centroids() const noexcept {
  return {.one = mean_shift(bins_[1].sum, bins_[1].count), .more = mean_shift(bins_[2].sum, bins_[2].count)};
}

double BinErrors::rms(const ReconstructionShift& shift) const noexcept {
  const std::array<double, 3> shifts = {0, shift.one / 256.0, shift.more / 256.0};
  double sum = 0;
  double count = 0;
  for (std::size_t i = 0; i < bins_.size(); ++i) {
    sum += bins_[i].squares - 2 * shifts[i] * bins_[i].sum + shifts[i] * shifts[i] * bins_[i].count;
    count += bins_[i].count;
  }
  return count > 0 ? step_ * std::sqrt(3 * std::max(sum, 0.0) / count) : 0;  // three numbers per vertex
}

}  // namespace deltamesh
