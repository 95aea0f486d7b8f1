// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From a delta coordinate to its symbol and back.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "base/numbers/vec3.h"
#include "format/highpass_parameters.h"
#include "laplacian/operator/delta_view.h"

namespace deltamesh {

/// What symbols stand for: `shift` is in 256ths of a step.
inline DeltaScale scale_of(double step, const ReconstructionShift& shift) noexcept {
  return {.step = step, .shifts = {0, shift.one / 256.0, shift.more / 256.0}};
}

/// Largest magnitude of a symbol that an encoder makes.
inline constexpr double kLargestSymbol = (1 << 23) - 1;

struct DeltaQuantizer {
  double step = 1;  ///< model units
  ReconstructionShift shift{};

  /// The nearest symbol where shifts are 0: a whole number, to be checked against kLargestSymbol.
  double symbol(double delta) const noexcept {
    const double steps = std::abs(delta) / step + 0.5;
    // Through an integer, several times as fast as std::floor; what is too large for one is whole already.
    const double whole = steps < 0x1p53 ? static_cast<double>(static_cast<std::int64_t>(steps)) : steps;
    return std::copysign(whole, delta);
  }
  double value(std::int32_t q) const noexcept { return scale_of(step, shift).value(q); }
};

/// Errors of quantised deltas, by the classes of the reconstruction shifts: symbols of size 0, 1, and larger.
class BinErrors {
 public:
  /// Errors of the nearest symbols. O(n).
  BinErrors(double step, std::span<const Vec3> deltas) noexcept;
  /// Errors of `symbols`: x of all vertices, then y, then z. O(n).
  BinErrors(double step, std::span<const Vec3> deltas, std::span<const std::int32_t> symbols) noexcept;

  /// Brings the reconstruction points to the centroids of their bins.
  ReconstructionShift centroids() const noexcept;
  /// Root mean square per vertex of the errors under `shift`, model units.
  double rms(const ReconstructionShift& shift) const noexcept;
  double largest_symbol() const noexcept { return largest_; }

 private:
  /// Sums over symbol minus delta, both multiplied by the symbol's sign, in steps.
  struct Bin {
    double sum = 0;
    double squares = 0;
    double count = 0;
  };

  /// `symbol`: 0 or more.
  void add(double symbol, double steps) noexcept {
    Bin& bin = bins_[static_cast<std::size_t>(std::min(symbol, 2.0))];
    const double excess = symbol - steps;
    bin.sum += excess;
    bin.squares += excess * excess;
    bin.count += 1;
    largest_ = std::max(largest_, symbol);
  }

  std::array<Bin, 3> bins_{};
  double step_;
  double largest_ = 0;
};

}  // namespace deltamesh
