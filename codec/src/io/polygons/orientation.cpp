// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/polygons/orientation.h"

#include <cmath>
#include <cstddef>

namespace deltamesh {
namespace {

/// A sum of doubles without rounding: parts that do not overlap, by growing size. Source: Shewchuk 1997,
/// Adaptive Precision Floating-Point Arithmetic, GROW-EXPANSION.
class ExactSum {
 public:
  void add_product(double x, double y) noexcept {
    const double product = x * y;
    add(std::fma(x, y, -product));
    add(product);
  }
  int sign() const noexcept {
    for (std::size_t i = size_; i-- > 0;)
      if (parts_[i] != 0) return parts_[i] > 0 ? 1 : -1;
    return 0;
  }

 private:
  void add(double x) noexcept {
    for (std::size_t i = 0; i < size_; ++i) {  // TWO-SUM
      const double sum = x + parts_[i];
      const double of_part = sum - x;
      parts_[i] = (x - (sum - of_part)) + (parts_[i] - of_part);
      x = sum;
    }
    parts_[size_++] = x;
  }

  std::array<double, 12> parts_{};
  std::size_t size_ = 0;
};

}  // namespace

int orientation(const Vec2& a, const Vec2& b, const Vec2& c) noexcept {
  const double left = (b[0] - a[0]) * (c[1] - a[1]);
  const double right = (b[1] - a[1]) * (c[0] - a[0]);
  const double determinant = left - right;
  // Shewchuk's bound of the rounding, (3 + 16 e) e, e = 2^-53.
  constexpr double kBound = 3.3306690738754716e-16;
  if (std::fabs(determinant) > kBound * (std::fabs(left) + std::fabs(right))) return determinant > 0 ? 1 : -1;
  ExactSum sum;
  sum.add_product(a[0], b[1]);
  sum.add_product(-a[1], b[0]);
  sum.add_product(b[0], c[1]);
  sum.add_product(-b[1], c[0]);
  sum.add_product(c[0], a[1]);
  sum.add_product(-c[1], a[0]);
  return sum.sign();
}

}  // namespace deltamesh
