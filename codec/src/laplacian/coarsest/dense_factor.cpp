// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/coarsest/dense_factor.h"

namespace deltamesh::multigrid {

DenseFactor::DenseFactor(const Level& level, std::span<const double> inverse_mass)
    : size_(level.node_count()), lower_(size_ * size_, 0.0), inverse_diagonal_(size_) {
  assemble(level, inverse_mass);
  factor();
}

/// Adds row r of K, times 1 / M and itself, for every r.
void DenseFactor::assemble(const Level& level, std::span<const double> inverse_mass) {
  for (std::uint32_t r = 0; r < size_; ++r) {
    const auto visit_k = [&](const auto& each) {
      each(r, static_cast<double>(level.degree[r]));
      for (std::uint32_t e = level.offsets[r]; e < level.offsets[r + 1]; ++e)
        each(level.neighbors[e], -static_cast<double>(level.weights[e]));
    };
    visit_k([&](std::uint32_t i, double a) {
      visit_k([&](std::uint32_t j, double b) { row(i)[j] += a * b * inverse_mass[r]; });
    });
  }
  for (const std::uint32_t anchor : level.anchors) row(anchor)[anchor] += 1;
}

void DenseFactor::factor() {
  std::vector<double> scaled(size_);
  for (std::size_t i = 0; i < size_; ++i) {
    double pivot = row(i)[i];
    for (std::size_t j = 0; j < i; ++j) {
      double sum = row(i)[j];
      for (std::size_t k = 0; k < j; ++k) sum -= scaled[k] * row(j)[k];
      scaled[j] = sum;
      row(i)[j] = sum * inverse_diagonal_[j];
      pivot -= sum * row(i)[j];
    }
    inverse_diagonal_[i] = pivot > 0 ? 1 / pivot : 0;
  }
}

void DenseFactor::solve(std::span<Double4> b) const noexcept {
  for (std::size_t i = 0; i < size_; ++i) {
    for (std::size_t j = 0; j < i; ++j) b[i] -= row(i)[j] * b[j];
  }
  for (std::size_t i = size_; i-- > 0;) {
    b[i] = inverse_diagonal_[i] * b[i];
    for (std::size_t k = i + 1; k < size_; ++k) b[i] -= row(k)[i] * b[k];
  }
}

}  // namespace deltamesh::multigrid
