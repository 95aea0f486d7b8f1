// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid_conjugate_gradients.h"

#include <algorithm>
#include <type_traits>
#include <vector>

#include "laplacian/multigrid_edges.h"

namespace deltamesh::multigrid {
namespace {

constexpr double kFloatsReduce = 1e-3;

/// Axis by axis a / b; 0 where b is not above 0.
Double4 ratio(const Double4& a, const Double4& b) noexcept {
  const auto divide = [](double p, double q) { return q > 0 ? p / q : 0.0; };
  return {TwoDoubles{divide(a.xy[0], b.xy[0]), divide(a.xy[1], b.xy[1])},
          TwoDoubles{divide(a.zw[0], b.zw[0]), 0.0}};
}

bool all_at_most(const Double4& a, const Double4& b) noexcept {
  return a.xy[0] <= b.xy[0] && a.xy[1] <= b.xy[1] && a.zw[0] <= b.zw[0];
}

/// Four: Float4 or Double4; sums over all nodes are doubles.
template <class Four>
class Iterations final : public ConjugateGradients {
 public:
  Iterations(const CoarsestNodes& nodes, double reduction)
      : level_(nodes.level),
        is_anchor_(nodes.is_anchor),
        reduction_(reduction),
        inverse_mass_(nodes.inverse_mass.begin(), nodes.inverse_mass.end()) {
    const std::uint32_t n = level_.node_count();
    for (std::uint32_t i = 0; i < n; ++i) {
      const double diagonal = diagonal_entry(nodes, i);
      inverse_diagonal_.push_back(diagonal > 0 ? static_cast<Number>(1 / diagonal) : 0);
    }
    for (auto* vector : {&solution_, &residual_, &direction_, &product_, &preconditioned_, &image_})
      vector->resize(n);
  }

  std::uint32_t solve(std::span<Double4> x, std::uint32_t most_iterations) override {
    for (std::size_t i = 0; i < x.size(); ++i) {
      residual_[i] = as_four(x[i]);
      solution_[i] = Four{};
    }
    const std::uint32_t iterations = iterate(most_iterations);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = as_doubles(solution_[i]);
    return iterations;
  }

 private:
  using Number = std::conditional_t<std::is_same_v<Four, Float4>, float, double>;

  static Four as_four(const Double4& v) noexcept {
    if constexpr (std::is_same_v<Four, Float4>) {
      return narrow(v);
    } else {
      return v;
    }
  }

  static Double4 as_doubles(const Four& v) noexcept {
    if constexpr (std::is_same_v<Four, Float4>) {
      return widen(v);
    } else {
      return v;
    }
  }

  static double diagonal_entry(const CoarsestNodes& nodes, std::uint32_t node) noexcept {
    const Level& level = nodes.level;
    const double degree = level.degree[node];
    double sum = degree * degree * nodes.inverse_mass[node] + nodes.is_anchor[node];
    for (std::uint32_t e = level.offsets[node]; e < level.offsets[node + 1]; ++e) {
      const double weight = level.weight(e);
      sum += weight * weight * nodes.inverse_mass[level.neighbors[e]];
    }
    return sum;
  }

  /// In plain order.
  static Double4 dot(std::span<const Four> a, std::span<const Four> b) noexcept {
    Double4 sum{};
    for (std::size_t i = 0; i < a.size(); ++i) sum += as_doubles(a[i]) * as_doubles(b[i]);
    return sum;
  }

  /// image_ serves as M^-1 K in.
  void apply_matrix(const std::vector<Four>& in, std::vector<Four>& out) noexcept {
    for (std::uint32_t i = 0; i < in.size(); ++i) image_[i] = inverse_mass_[i] * apply_k(level_, in, i);
    for (std::uint32_t i = 0; i < in.size(); ++i) {
      out[i] = apply_k(level_, image_, i);
      if (is_anchor_[i] != 0) out[i] += in[i];
    }
  }

  /// image_ is M^-1 K z throughout, so that both the row of the matrix and the effect of a step need only the
  /// neighbours (Bjoerck, Elfving, Accelerated projection methods, 1979).
  void relax(std::uint32_t node) noexcept {
    Four& z = preconditioned_[node];
    Four sum = residual_[node] - apply_k(level_, image_, node);
    if (is_anchor_[node] != 0) sum -= z;
    const Four step = inverse_diagonal_[node] * sum;
    z += step;
    image_[node] += inverse_mass_[node] * static_cast<Number>(level_.degree[node]) * step;
    for (std::uint32_t e = level_.offsets[node]; e < level_.offsets[node + 1]; ++e) {
      const std::uint32_t other = level_.neighbors[e];
      image_[other] -= inverse_mass_[other] * static_cast<Number>(level_.weight(e)) * step;
    }
  }

  /// Symmetric Gauss-Seidel: a forward sweep from zero, then a backward one.
  void precondition() noexcept {
    const std::uint32_t n = level_.node_count();
    std::fill(preconditioned_.begin(), preconditioned_.end(), Four{});
    std::fill(image_.begin(), image_.end(), Four{});
    for (std::uint32_t i = 0; i < n; ++i) relax(i);
    for (std::uint32_t i = n; i-- > 0;) relax(i);
  }

  std::uint32_t iterate(std::uint32_t most_iterations) noexcept {
    precondition();
    direction_ = preconditioned_;
    Double4 energy = dot(residual_, preconditioned_);
    const Double4 small = reduction_ * reduction_ * energy;
    for (std::uint32_t iteration = 1; iteration <= most_iterations; ++iteration) {
      apply_matrix(direction_, product_);
      const Four step = as_four(ratio(energy, dot(direction_, product_)));
      for (std::size_t i = 0; i < solution_.size(); ++i) {
        solution_[i] += step * direction_[i];
        residual_[i] -= step * product_[i];
      }
      precondition();
      const Double4 next = dot(residual_, preconditioned_);
      if (all_at_most(next, small)) return iteration;
      const Four conjugate = as_four(ratio(next, energy));
      energy = next;
      for (std::size_t i = 0; i < solution_.size(); ++i)
        direction_[i] = preconditioned_[i] + conjugate * direction_[i];
    }
    return most_iterations;
  }

  const Level& level_;
  std::span<const std::uint8_t> is_anchor_;
  double reduction_;
  std::vector<Number> inverse_mass_;
  std::vector<Number> inverse_diagonal_;
  std::vector<Four> solution_, residual_, direction_, product_, preconditioned_;
  std::vector<Four> image_;  ///< M^-1 K of another vector
};

}  // namespace

std::unique_ptr<ConjugateGradients> make_conjugate_gradients(const CoarsestNodes& nodes, double reduction) {
  if (reduction >= kFloatsReduce) return std::make_unique<Iterations<Float4>>(nodes, reduction);
  return std::make_unique<Iterations<Double4>>(nodes, reduction);
}

}  // namespace deltamesh::multigrid
