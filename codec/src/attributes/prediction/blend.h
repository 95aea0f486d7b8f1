// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Blends several predictions of a pair of numbers. Weights are learnt by least squares on the differences of
// the other predictions from the first [ATTR-35]. The same bits on every machine.
#pragma once

#include <array>

#include "base/simd/two_doubles.h"

namespace deltamesh {

inline double dot(TwoDoubles a, TwoDoubles b) noexcept { return a[0] * b[0] + a[1] * b[1]; }

/// The differences of two predictions from the first one.
using PredictionDifferences = std::array<TwoDoubles, 2>;

class PredictionBlend {
 public:
  /// The correction to add to the first prediction.
  TwoDoubles correction(const PredictionDifferences& d) const noexcept {
    const double a = squares_[0] + kRidge;
    const double c = squares_[1] + kRidge;
    const double determinant = a * c - mixed_ * mixed_;
    if (!(determinant > 0)) return TwoDoubles{};
    const double inverse = 1 / determinant;
    const double first = inverse * (c * products_[0] - mixed_ * products_[1]);
    const double second = inverse * (a * products_[1] - mixed_ * products_[0]);
    return first * d[0] + second * d[1];
  }

  /// `error`: what came less the first prediction. `weight`: above 0.
  void learn(const PredictionDifferences& d, TwoDoubles error, double weight) noexcept {
    squares_ = kMemory * squares_ + weight * TwoDoubles{dot(d[0], d[0]), dot(d[1], d[1])};
    mixed_ = kMemory * mixed_ + weight * dot(d[0], d[1]);
    products_ = kMemory * products_ + weight * TwoDoubles{dot(d[0], error), dot(d[1], error)};
  }

 private:
  static constexpr double kMemory = 0.99;
  static constexpr double kRidge = 0.02;

  TwoDoubles squares_{};
  TwoDoubles products_{};
  double mixed_ = 0;
};

}  // namespace deltamesh
