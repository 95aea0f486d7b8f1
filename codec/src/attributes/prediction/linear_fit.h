// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Pairs of numbers as a linear function of a place in space, fitted to those before by least squares
// [ATTR-34]. The same bits on every machine: doubles, + - * / in the order written.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/numbers/vec3.h"
#include "base/simd/two_doubles.h"

namespace deltamesh {

/// The upper triangle, row by row: 00 01 02 11 12 22.
using SymmetricMatrix = std::array<double, 6>;

/// Solves m x = y by the adjugate. 0 where the determinant is not above 0. `T`: double, or several of them.
template <class T>
std::array<T, 3> solve_symmetric(const SymmetricMatrix& m, const std::array<T, 3>& y) noexcept {
  const double aa = m[3] * m[5] - m[4] * m[4];
  const double ab = m[2] * m[4] - m[1] * m[5];
  const double ac = m[1] * m[4] - m[2] * m[3];
  const double bb = m[0] * m[5] - m[2] * m[2];
  const double bc = m[1] * m[2] - m[0] * m[4];
  const double cc = m[0] * m[3] - m[1] * m[1];
  const double determinant = (m[0] * aa + m[1] * ab) + m[2] * ac;
  if (!(determinant > 0)) return {};
  const double inverse = 1 / determinant;
  return {inverse * ((aa * y[0] + ab * y[1]) + ac * y[2]), inverse * ((ab * y[0] + bb * y[1]) + bc * y[2]),
          inverse * ((ac * y[0] + bc * y[1]) + cc * y[2])};
}

class LinearFit {
 public:
  /// The function at `z`, each coordinate about -0.5 to 0.5; 0 before the first sample.
  TwoDoubles at(const Vec3& z) const noexcept {
    return ((value_ + (z[0] - mean_[0]) * slopes_[0]) + (z[1] - mean_[1]) * slopes_[1]) +
           (z[2] - mean_[2]) * slopes_[2];
  }

  void learn(const Vec3& z, TwoDoubles value) noexcept {
    const std::uint32_t age = age_++;
    if (age >= kYoung && age % kPeriod != 0) return;
    count_ = count_ * kMemory + 1;
    values_ = values_ * kMemory + value;
    std::size_t k = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      places_[i] = places_[i] * kMemory + z[i];
      products_[i] = products_[i] * kMemory + z[i] * value;
      for (std::size_t j = i; j < 3; ++j, ++k) squares_[k] = squares_[k] * kMemory + z[i] * z[j];
    }
    fit();
  }

  /// Reduces the weight of everything learnt so far by kFaded.
  void fade() noexcept {
    age_ = 0;
    count_ *= kFaded;
    values_ *= kFaded;
    for (double& x : places_) x *= kFaded;
    for (TwoDoubles& x : products_) x *= kFaded;
    for (double& x : squares_) x *= kFaded;
  }

 private:
  static constexpr double kRidge = 1e-6;        ///< of the variance
  static constexpr double kLeastRidge = 1e-12;  ///< squared coordinates
  static constexpr double kFaded = 1.0 / 1024;

  static constexpr double kMemory = 0.98;  ///< what a sample counts less with each that comes after
  /// All of the first values are learnt, and some of the others only: it takes time.
  static constexpr std::uint32_t kYoung = 8;
  static constexpr std::uint32_t kPeriod = 4;

  void fit() noexcept {
    const double inverse = 1 / count_;
    mean_ = inverse * places_;
    value_ = inverse * values_;
    SymmetricMatrix covariance;
    std::size_t k = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = i; j < 3; ++j, ++k) covariance[k] = inverse * squares_[k] - mean_[i] * mean_[j];
      slopes_[i] = inverse * products_[i] - mean_[i] * value_;
    }
    const double ridge = kRidge * ((covariance[0] + covariance[3]) + covariance[5]) + kLeastRidge;
    for (const std::size_t i : {0, 3, 5}) covariance[i] += ridge;
    slopes_ = solve_symmetric(covariance, slopes_);
  }

  std::uint32_t age_ = 0;  ///< values since the last fade()
  // The function.
  TwoDoubles value_{};
  Vec3 mean_{};
  std::array<TwoDoubles, 3> slopes_{};
  // Sums over the samples, weighted.
  double count_ = 0;
  TwoDoubles values_{};
  Vec3 places_{};
  std::array<TwoDoubles, 3> products_{};
  SymmetricMatrix squares_{};
};

}  // namespace deltamesh
