// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/dense_component.h"

#include <algorithm>

namespace deltamesh::settling {
namespace {

/// Pivots of a component of 64 vertices with an anchor stay far above.
constexpr double kSmallestPivot = 1e-12;

/// a -= factor * b
void subtract(double factor, const Vec3& b, Vec3& a) noexcept {
  for (std::size_t axis = 0; axis < 3; ++axis) a[axis] -= factor * b[axis];
}

}  // namespace

void DenseComponent::begin(std::uint32_t size) noexcept {
  size_ = size;
  for (std::uint32_t i = 0; i < size; ++i) {
    std::fill(row(i) + i, row(i) + size, 0.0);
    end_[i] = i + 1;
    right_[i] = Vec3{};
  }
}

void DenseComponent::add_row(std::uint32_t own, std::span<const std::uint32_t> columns,
                             const Vec3& delta) noexcept {
  const double beside = -1.0 / static_cast<double>(columns.size() - 1);
  for (std::size_t a = 0; a < columns.size(); ++a) {
    const std::uint32_t i = columns[a];
    const double factor = i == own ? 1.0 : beside;
    for (std::size_t b = a; b < columns.size(); ++b)
      row(i)[columns[b]] += factor * (columns[b] == own ? 1.0 : beside);
    end_[i] = std::max(end_[i], columns.back() + 1);
    subtract(-factor, delta, right_[i]);
  }
}

void DenseComponent::add_anchor(std::uint32_t own, const Vec3& position) noexcept {
  row(own)[own] += 1.0;  // w = 1
  right_[own] = right_[own] + position;
}

bool DenseComponent::solve() noexcept {
  for (std::uint32_t k = 0; k < size_; ++k) {
    const double* pivot_row = row(k);
    if (!(pivot_row[k] > kSmallestPivot)) return false;
    const double inverse = 1 / pivot_row[k];
    for (std::uint32_t i = k + 1; i < end_[k]; ++i) {
      const double factor = pivot_row[i] * inverse;
      if (factor == 0) continue;
      double* target = row(i);
      for (std::uint32_t j = i; j < end_[k]; ++j) target[j] -= factor * pivot_row[j];
      end_[i] = std::max(end_[i], end_[k]);
      subtract(factor, right_[k], right_[i]);
    }
  }
  for (std::uint32_t k = size_; k-- > 0;) {
    const double* pivot_row = row(k);
    for (std::uint32_t j = k + 1; j < end_[k]; ++j) subtract(pivot_row[j], right_[j], right_[k]);
    right_[k] = (1 / pivot_row[k]) * right_[k];
  }
  return true;
}

}  // namespace deltamesh::settling
