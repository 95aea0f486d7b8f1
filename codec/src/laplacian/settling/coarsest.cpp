// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/coarsest.h"

#include <algorithm>

#include "laplacian/settling/edges.h"

namespace deltamesh::settling {
namespace {

/// Bound of (degree + 1)^2 summed over the nodes, which is what forming K M^-1 K costs, and so of its
/// entries: meshes stay below 100 per node, a hub alone could fill the matrix.
constexpr std::uint64_t kMostProductsPerNode = 256;
constexpr std::uint64_t kFewestProducts = std::uint64_t{1} << 20;

/// Collects one row of a sparse matrix.
class RowBuilder {
 public:
  explicit RowBuilder(std::uint32_t columns) : sums_(columns, 0.0), seen_(columns, 0) {}

  void add(std::uint32_t column, double value) {
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
  std::vector<double> sums_;
  std::vector<std::uint8_t> seen_;
  std::vector<std::uint32_t> touched_;
};

}  // namespace

CoarsestSolver::CoarsestSolver(const Level& level, std::span<const std::uint8_t> holds, CoarsestEffort effort)
    : level_(level),
      holds_(holds),
      inverse_mass_(level.node_count()),
      scaled_(level.node_count()),
      x_(level.node_count()) {
  const std::uint32_t n = level.node_count();
  for (std::uint32_t i = 0; i < n; ++i)
    inverse_mass_[i] = level.mass[i] > 0 ? 1 / static_cast<double>(level.mass[i]) : 0.0;
  is_anchor_.assign(n, 0);
  for (const std::uint32_t anchor : level.anchors) is_anchor_[anchor] = 1;
  if (n <= effort.largest_factored && product_stays_sparse()) factor_ = SparseFactor::make(assemble());
  if (!factor_)
    conjugate_gradients_ = make_conjugate_gradients({level_, inverse_mass_, is_anchor_}, effort.reduction);
}

bool CoarsestSolver::product_stays_sparse() const noexcept {
  const std::uint64_t n = level_.node_count();
  const std::uint64_t most = std::max(kMostProductsPerNode * n, kFewestProducts);
  std::uint64_t products = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    std::uint64_t entries = 1;
    for (std::uint32_t e = level_.offsets[i]; e < level_.offsets[i + 1]; ++e)
      entries += level_.weight(e) > 0 ? 1 : 0;
    if (entries > most) return false;
    products += entries * entries;
    if (products > most) return false;
  }
  return true;
}

SymmetricMatrix CoarsestSolver::assemble() const {
  const std::uint32_t n = level_.node_count();
  SymmetricMatrix matrix;
  RowBuilder row(n);
  const auto add_row_of_k = [&](std::uint32_t node, double factor) {
    factor *= inverse_mass_[node];
    row.add(node, factor * static_cast<double>(level_.degree[node]));
    for (std::uint32_t e = level_.offsets[node]; e < level_.offsets[node + 1]; ++e)
      row.add(level_.neighbors[e], -factor * static_cast<double>(level_.weight(e)));
  };
  matrix.offsets.assign(1, 0);
  matrix.diagonal.assign(n, 0.0);
  for (std::uint32_t i = 0; i < n; ++i) {
    add_row_of_k(i, level_.degree[i]);
    for (std::uint32_t e = level_.offsets[i]; e < level_.offsets[i + 1]; ++e)
      add_row_of_k(level_.neighbors[e], -static_cast<double>(level_.weight(e)));
    if (is_anchor_[i] != 0) row.add(i, 1.0);
    row.finish([&](std::uint32_t column, double value) {
      if (column == i) {
        matrix.diagonal[i] = value;
        return;
      }
      matrix.columns.push_back(column);
      matrix.values.push_back(value);
    });
    matrix.offsets.push_back(static_cast<std::uint32_t>(matrix.columns.size()));
  }
  return matrix;
}

std::uint32_t CoarsestSolver::solve(std::span<const Row> b, std::span<const Float4> gaps, std::span<Row> u,
                                    std::span<Float4> forces, std::uint32_t most_iterations) {
  std::uint32_t iterations = 0;
  const std::uint32_t n = level_.node_count();
  for (std::uint32_t i = 0; i < n; ++i) scaled_[i] = inverse_mass_[i] * widen(b[i].x);
  for (std::uint32_t i = 0; i < n; ++i) x_[i] = apply_k(level_, scaled_, i) - widen(b[i].s);
  for (std::size_t a = 0; a < gaps.size(); ++a) x_[level_.anchors[a]] += widen(gaps[a]);
  if (factor_) {
    factor_->solve(x_);
  } else {
    iterations = conjugate_gradients_->solve(x_, most_iterations);
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    u[i].x = narrow(x_[i]);
    u[i].s = narrow(scaled_[i] - inverse_mass_[i] * apply_k(level_, x_, i));
  }
  for (std::size_t a = 0; a < gaps.size(); ++a)
    forces[a] = holds_[a] != 0 ? narrow(x_[level_.anchors[a]]) - gaps[a] : Float4{};
  return iterations;
}

}  // namespace deltamesh::settling
