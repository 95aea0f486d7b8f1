// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid_conjugate_gradients.h"

#include <algorithm>
#include <type_traits>
#include <vector>

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

/// Four: Float4 or Double4; sums over all nodes are doubles. A K M^-1 K z needs y = K z and its neighbours
/// only, which is kept up with z [Bjoerck, Elfving, Accelerated projection methods, 1979].
template <class Four>
class Iterations final : public ConjugateGradients {
 public:
  Iterations(const CoarsestNodes& nodes, double reduction) : reduction_(reduction) {
    const std::uint32_t n = nodes.level.node_count();
    for (std::uint32_t i = 0; i < n; ++i) add_node(nodes, i);
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

  struct Node {
    std::uint32_t first_edge;  ///< the last is the one before the next node's first
    Number degree;
    Number scaled_degree;     ///< over the mass
    Number inverse_diagonal;  ///< of the matrix
    Number anchor;            ///< 1, or 0 where it is none
  };
  struct Edge {
    std::uint32_t neighbor;
    Number weight;
    Number scaled_weight;  ///< over the neighbour's mass
  };

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

  void add_node(const CoarsestNodes& nodes, std::uint32_t node) {
    const Level& level = nodes.level;
    const double degree = level.degree[node];
    const double anchor = nodes.is_anchor[node];
    const auto first_edge = static_cast<std::uint32_t>(edges_.size());
    double diagonal = degree * degree * nodes.inverse_mass[node] + anchor;
    for (std::uint32_t e = level.offsets[node]; e < level.offsets[node + 1]; ++e) {
      const double weight = level.weight(e);
      if (weight == 0) continue;  // that of pad_rows()
      const std::uint32_t neighbor = level.neighbors[e];
      const double scaled = weight * nodes.inverse_mass[neighbor];
      diagonal += weight * scaled;
      edges_.push_back({neighbor, static_cast<Number>(weight), static_cast<Number>(scaled)});
    }
    if (nodes_.empty()) nodes_.emplace_back();
    nodes_.back() = {first_edge, static_cast<Number>(degree),
                     static_cast<Number>(degree * nodes.inverse_mass[node]),
                     static_cast<Number>(diagonal > 0 ? 1 / diagonal : 0), static_cast<Number>(anchor)};
    nodes_.push_back({static_cast<std::uint32_t>(edges_.size()), 0, 0, 0, 0});
  }

  /// Of A z, with image_ = K z.
  Four matrix_row(std::uint32_t i, const Four& z) const noexcept {
    const Node& node = nodes_[i];
    Four sum = node.scaled_degree * image_[i] + node.anchor * z;
    for (std::uint32_t e = node.first_edge; e < nodes_[i + 1].first_edge; ++e)
      sum -= edges_[e].scaled_weight * image_[edges_[e].neighbor];
    return sum;
  }

  void relax(std::uint32_t i) noexcept {
    const Node& node = nodes_[i];
    Four& z = preconditioned_[i];
    const Four step = node.inverse_diagonal * (residual_[i] - matrix_row(i, z));
    z += step;
    image_[i] += node.degree * step;
    for (std::uint32_t e = node.first_edge; e < nodes_[i + 1].first_edge; ++e)
      image_[edges_[e].neighbor] -= edges_[e].weight * step;
  }

  /// Symmetric Gauss-Seidel: a forward sweep from zero, then a backward one.
  void precondition() noexcept {
    const auto n = static_cast<std::uint32_t>(solution_.size());
    std::fill(preconditioned_.begin(), preconditioned_.end(), Four{});
    std::fill(image_.begin(), image_.end(), Four{});
    for (std::uint32_t i = 0; i < n; ++i) relax(i);
    for (std::uint32_t i = n; i-- > 0;) relax(i);
  }

  /// Sum, in plain order, of residual times what Gauss-Seidel makes of it.
  Double4 residual_energy() const noexcept {
    Double4 sum{};
    for (std::size_t i = 0; i < residual_.size(); ++i)
      sum += as_doubles(residual_[i]) * as_doubles(preconditioned_[i]);
    return sum;
  }

  /// The direction becomes the preconditioned residual and `share` of what it was; its energy.
  Double4 turn(const Four& share) noexcept {
    Double4 energy{};
    for (std::uint32_t i = 0; i < direction_.size(); ++i) {
      direction_[i] = preconditioned_[i] + share * direction_[i];
      product_[i] = matrix_row(i, preconditioned_[i]) + share * product_[i];
      energy += as_doubles(direction_[i]) * as_doubles(product_[i]);
    }
    return energy;
  }

  /// Sum of the squares of the residual, each over the diagonal's entry.
  Double4 residual_squares() const noexcept {
    Double4 sum{};
    for (std::size_t i = 0; i < residual_.size(); ++i)
      sum += as_doubles(nodes_[i].inverse_diagonal * residual_[i]) * as_doubles(residual_[i]);
    return sum;
  }

  std::uint32_t iterate(std::uint32_t most_iterations) noexcept {
    std::fill(direction_.begin(), direction_.end(), Four{});
    std::fill(product_.begin(), product_.end(), Four{});
    const Double4 small = reduction_ * reduction_ * residual_squares();
    Double4 energy{};
    for (std::uint32_t iteration = 1;; ++iteration) {
      precondition();
      const Double4 next = residual_energy();
      const Four share = as_four(ratio(next, energy));
      energy = next;
      const Four step = as_four(ratio(energy, turn(share)));
      for (std::size_t i = 0; i < solution_.size(); ++i) {
        solution_[i] += step * direction_[i];
        residual_[i] -= step * product_[i];
      }
      const Double4 left = residual_squares();
      if (all_at_most(left, small) || iteration >= most_iterations) return iteration;
    }
  }

  double reduction_;
  std::vector<Node> nodes_;  ///< and one for the end
  std::vector<Edge> edges_;
  std::vector<Four> solution_, residual_;
  std::vector<Four> direction_, product_;     ///< d and A d
  std::vector<Four> preconditioned_, image_;  ///< z and K z
};

}  // namespace

std::unique_ptr<ConjugateGradients> make_conjugate_gradients(const CoarsestNodes& nodes, double reduction) {
  if (reduction >= kFloatsReduce) return std::make_unique<Iterations<Float4>>(nodes, reduction);
  return std::make_unique<Iterations<Double4>>(nodes, reduction);
}

}  // namespace deltamesh::multigrid
