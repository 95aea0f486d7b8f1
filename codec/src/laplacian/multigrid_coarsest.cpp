// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid_coarsest.h"

#include <algorithm>
#include <array>

namespace deltamesh::multigrid {
namespace {

constexpr double kReduction = 1e-3;
constexpr int kMaxIterations = 500;

using Dots = std::array<double, 3>;

/// In plain order and double precision.
Dots dot(std::span<const Float4> a, std::span<const Float4> b) noexcept {
  Dots sum{};
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis)
      sum[static_cast<std::size_t>(axis)] +=
          static_cast<double>(a[i][axis]) * static_cast<double>(b[i][axis]);
  }
  return sum;
}

Float4 ratio(const Dots& a, const Dots& b) noexcept {
  Float4 result{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    result[axis] = b[k] > 0 ? static_cast<float>(a[k] / b[k]) : 0.0F;
  }
  return result;
}

/// Collects one row of a sparse matrix.
class RowBuilder {
 public:
  explicit RowBuilder(std::uint32_t columns) : sums_(columns, 0.0F), seen_(columns, 0) {}

  void add(std::uint32_t column, float value) {
    if (seen_[column] == 0) {
      seen_[column] = 1;
      touched_.push_back(column);
    }
    sums_[column] += value;
  }

  /// Calls emit(column, value) in ascending order and clears the row.
  template <class Emit>
  void finish(const Emit& emit) {
    std::sort(touched_.begin(), touched_.end());
    for (const std::uint32_t column : touched_) {
      emit(column, sums_[column]);
      sums_[column] = 0;
      seen_[column] = 0;
    }
    touched_.clear();
  }

 private:
  std::vector<float> sums_;
  std::vector<std::uint8_t> seen_;
  std::vector<std::uint32_t> touched_;
};

}  // namespace

CoarsestSolver::CoarsestSolver(const Level& level) : level_(level) {
  assemble();
  for (auto* vector : {&scaled_, &x_, &residual_, &direction_, &product_, &preconditioned_})
    vector->resize(level.node_count());
}

void CoarsestSolver::assemble() {
  const std::uint32_t n = level_.node_count();
  std::vector<std::uint8_t> is_anchor(n, 0);
  for (const std::uint32_t anchor : level_.anchors) is_anchor[anchor] = 1;
  RowBuilder row(n);
  const auto add_row_of_k = [&](std::uint32_t node, float factor) {
    if (level_.mass[node] == 0) return;  // a lone node: its row of K is 0
    factor /= level_.mass[node];
    row.add(node, factor * level_.degree[node]);
    for (std::uint32_t e = level_.offsets[node]; e < level_.offsets[node + 1]; ++e)
      row.add(level_.neighbors[e], -factor * level_.weight(e));
  };
  offsets_.assign(1, 0);
  diagonal_.assign(n, 0.0F);
  inverse_diagonal_.assign(n, 0.0F);
  for (std::uint32_t i = 0; i < n; ++i) {
    add_row_of_k(i, level_.degree[i]);
    for (std::uint32_t e = level_.offsets[i]; e < level_.offsets[i + 1]; ++e)
      add_row_of_k(level_.neighbors[e], -level_.weight(e));
    if (is_anchor[i] != 0) row.add(i, 1.0F);
    std::uint32_t below = 0;
    row.finish([&](std::uint32_t column, float value) {
      if (column == i) {
        diagonal_[i] = value;
        return;
      }
      if (column < i) ++below;
      columns_.push_back(column);
      values_.push_back(value);
    });
    if (diagonal_[i] > 0) inverse_diagonal_[i] = 1 / diagonal_[i];
    split_.push_back(offsets_.back() + below);
    offsets_.push_back(static_cast<std::uint32_t>(columns_.size()));
  }
}

Float4 CoarsestSolver::apply_k(std::span<const Float4> values, std::uint32_t node) const noexcept {
  Float4 sum = level_.degree[node] * values[node];
  for (std::uint32_t e = level_.offsets[node]; e < level_.offsets[node + 1]; ++e)
    sum -= level_.weight(e) * values[level_.neighbors[e]];
  return sum;
}

void CoarsestSolver::apply_matrix(std::span<const Float4> in, std::span<Float4> out) const noexcept {
  for (std::uint32_t i = 0; i < in.size(); ++i) {
    Float4 sum = diagonal_[i] * in[i];
    for (std::uint32_t e = offsets_[i]; e < offsets_[i + 1]; ++e) sum += values_[e] * in[columns_[e]];
    out[i] = sum;
  }
}

/// Symmetric Gauss-Seidel: a forward sweep from zero, then a backward one.
void CoarsestSolver::precondition() noexcept {
  const std::uint32_t n = level_.node_count();
  std::vector<Float4>& z = preconditioned_;
  for (std::uint32_t i = 0; i < n; ++i) {
    Float4 sum = residual_[i];
    for (std::uint32_t e = offsets_[i]; e < split_[i]; ++e) sum -= values_[e] * z[columns_[e]];
    z[i] = inverse_diagonal_[i] * sum;
  }
  for (std::uint32_t i = n; i-- > 0;) {
    Float4 sum{};
    for (std::uint32_t e = split_[i]; e < offsets_[i + 1]; ++e) sum += values_[e] * z[columns_[e]];
    z[i] -= inverse_diagonal_[i] * sum;
  }
}

void CoarsestSolver::run_conjugate_gradients() noexcept {
  std::fill(x_.begin(), x_.end(), Float4{});
  precondition();
  direction_ = preconditioned_;
  Dots energy = dot(residual_, preconditioned_);
  const Dots first = energy;
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    apply_matrix(direction_, product_);
    const Float4 step = ratio(energy, dot(direction_, product_));
    for (std::size_t i = 0; i < x_.size(); ++i) {
      x_[i] += step * direction_[i];
      residual_[i] -= step * product_[i];
    }
    precondition();
    const Dots next = dot(residual_, preconditioned_);
    bool small = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
      small = small && next[axis] <= kReduction * kReduction * first[axis];
    if (small) return;
    const Float4 conjugate = ratio(next, energy);
    energy = next;
    for (std::size_t i = 0; i < x_.size(); ++i)
      direction_[i] = preconditioned_[i] + conjugate * direction_[i];
  }
}

void CoarsestSolver::solve(std::span<const Row> b, std::span<const Float4> gaps, std::span<Row> u,
                           std::span<Float4> forces) {
  const std::uint32_t n = level_.node_count();
  for (std::uint32_t i = 0; i < n; ++i)
    scaled_[i] = (level_.mass[i] > 0 ? 1 / level_.mass[i] : 0.0F) * b[i].x;
  for (std::uint32_t i = 0; i < n; ++i) residual_[i] = apply_k(scaled_, i) - b[i].s;
  for (std::size_t a = 0; a < gaps.size(); ++a) residual_[level_.anchors[a]] += gaps[a];
  run_conjugate_gradients();
  for (std::uint32_t i = 0; i < n; ++i) {
    u[i].x = x_[i];
    u[i].s = scaled_[i] - (level_.mass[i] > 0 ? 1 / level_.mass[i] : 0.0F) * apply_k(x_, i);
  }
  for (std::size_t a = 0; a < gaps.size(); ++a) forces[a] = x_[level_.anchors[a]] - gaps[a];
}

}  // namespace deltamesh::multigrid
