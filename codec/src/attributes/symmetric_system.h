// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Three linear equations with a symmetric positive definite matrix. The same bits on every machine [ATTR-33].
#pragma once

#include <array>

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

}  // namespace deltamesh
