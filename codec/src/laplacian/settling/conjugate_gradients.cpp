// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/conjugate_gradients.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

#include "base/large_vector.h"
#include "laplacian/settling/parted_order.h"

namespace deltamesh::settling {
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

/// Four: Float4 or Double4; sums over all nodes are doubles. The matrix, scaled by the roots of its diagonal
/// S so that this becomes 1, is B^T B + S^-2 sum_a e_a e_a^T = L + I + L^T with B = M^-1/2 K S^-1. Solutions
/// with I + L and I + L^T need B and an image under B only [Bjoerck, Elfving, Accelerated projection methods,
/// 1979]; of symmetric Gauss-Seidel two of them make an iteration, for y = (I + L)^-1 r in place of the
/// residual r and (I + L^T) d beside the direction d [Eisenstat, Efficient implementation of a class of
/// preconditioned conjugate gradient methods, 1981].
template <class Four>
class Iterations final : public ConjugateGradients {
 public:
  Iterations(const CoarsestNodes& nodes, double reduction)
      : reduction_(reduction), order_(order_in_parts(nodes.level)) {
    const std::uint32_t n = nodes.level.node_count();
    pairs_.reserve(n + nodes.level.neighbors.size() / 2);  // of every node with its neighbours, rounded up
    for (const std::uint32_t node : order_.nodes) add_node(nodes, node);
    nodes_.push_back({static_cast<std::uint32_t>(pairs_.size()), 0, 0});
    for (auto* vector : {&solution_, &residual_, &direction_, &turned_, &product_, &image_})
      vector->resize(n);
  }

  std::uint32_t solve(std::span<Double4> x, std::uint32_t most_iterations) override {
    for (std::size_t i = 0; i < x.size(); ++i) solution_[i] = as_four(nodes_[i].scale * x[order_.nodes[i]]);
    const std::uint32_t iterations = iterate(most_iterations);
    for (std::size_t i = 0; i < x.size(); ++i)
      x[order_.nodes[i]] = nodes_[i].scale * as_doubles(solution_[i]);
    return iterations;
  }

 private:
  using Number = std::conditional_t<std::is_same_v<Four, Float4>, float, double>;

  struct Node {
    std::uint32_t first_pair;  ///< the last is the one before the next node's first
    Number anchor;             ///< 1 over the diagonal, or 0 where it is none
    double scale;              ///< 1 over the root of the diagonal
  };
  /// Two entries of a column of B.
  struct Pair {
    std::array<std::uint32_t, 2> rows;
    std::array<Number, 2> values;
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
    const auto visit_k = [&](const auto& each) {
      each(node, static_cast<double>(level.degree[node]));
      for (std::uint32_t e = level.offsets[node]; e < level.offsets[node + 1]; ++e)
        each(level.neighbors[e], -static_cast<double>(level.weight(e)));
    };
    double diagonal = nodes.is_anchor[node];
    visit_k([&](std::uint32_t row, double k) { diagonal += k * k * nodes.inverse_mass[row]; });
    const double scale = diagonal > 0 ? 1 / std::sqrt(diagonal) : 0;
    nodes_.push_back({static_cast<std::uint32_t>(pairs_.size()),
                      static_cast<Number>(nodes.is_anchor[node] * scale * scale), scale});
    bool is_half = false;
    visit_k([&](std::uint32_t row, double k) {
      const auto value = static_cast<Number>(k * scale * std::sqrt(nodes.inverse_mass[row]));
      if (value == 0) return;  // also that of pad_rows()
      if (is_half) {
        pairs_.back().rows[1] = row;
        pairs_.back().values[1] = value;
      } else {
        pairs_.push_back({{row, row}, {value, 0}});
      }
      is_half = !is_half;
    });
  }

  std::span<const Pair> column(std::uint32_t i) const noexcept {
    return {pairs_.data() + nodes_[i].first_pair, pairs_.data() + nodes_[i + 1].first_pair};
  }

  /// Of B^T times the image.
  Four row_of_image(std::uint32_t i) const noexcept {
    Four first{}, second{};
    for (const auto& [rows, values] : column(i)) {
      first += values[0] * image_[rows[0]];
      second += values[1] * image_[rows[1]];
    }
    return first + second;
  }

  /// What z at a node adds to the image.
  void add_to_image(std::uint32_t i, Four z) noexcept {
    for (const auto& [rows, values] : column(i)) {
      image_[rows[0]] += values[0] * z;
      image_[rows[1]] += values[1] * z;
    }
  }

  /// The sum of each(i), in order.
  template <class Each>
  Double4 sum_forward(const Each& each) {
    const auto sum = [&](std::uint32_t begin, std::uint32_t end) {
      Double4 energy{};
      for (std::uint32_t i = begin; i < end; ++i) energy += each(i);
      return energy;
    };
    std::array<Double4, PartedOrder::kParts> parts{};
    for (std::uint32_t part = 0; part < order_.parts(); ++part)
      parts[part] = sum(order_.begin(part), order_.end(part));
    return (parts[0] + parts[1]) + sum(order_.rest, order_.size());
  }

  /// Calls each(i), the other way round.
  template <class Each>
  void visit_backward(const Each& each) {
    const auto visit = [&](std::uint32_t begin, std::uint32_t end) {
      while (end > begin) each(--end);
    };
    visit(order_.rest, order_.size());
    for (std::uint32_t part = 0; part < order_.parts(); ++part) visit(order_.begin(part), order_.end(part));
  }

  /// y for a right-hand side that the solution, which becomes 0, holds; its square.
  Double4 begin() {
    std::fill(image_.begin(), image_.end(), Four{});
    const Double4 energy = sum_forward([&](std::uint32_t i) {
      residual_[i] = solution_[i] - row_of_image(i);
      add_to_image(i, residual_[i]);
      return as_doubles(residual_[i]) * as_doubles(residual_[i]);
    });
    std::fill(solution_.begin(), solution_.end(), Four{});
    std::fill(turned_.begin(), turned_.end(), Four{});
    return energy;
  }

  /// The direction becomes the preconditioned residual and `share` of what it was, the image its own.
  void turn(const Four& share) {
    std::fill(image_.begin(), image_.end(), Four{});
    visit_backward([&](std::uint32_t i) {
      turned_[i] = residual_[i] + share * turned_[i];
      direction_[i] = turned_[i] - row_of_image(i);
      add_to_image(i, direction_[i]);
    });
  }

  /// (I + L)^-1 A d from the direction's image, which is used up. Returns d A d.
  Double4 multiply() {
    return sum_forward([&](std::uint32_t i) {
      product_[i] = row_of_image(i) + nodes_[i].anchor * direction_[i];
      add_to_image(i, Four{} - product_[i]);
      return as_doubles(turned_[i]) * as_doubles(product_[i]);
    });
  }

  /// The square of what y becomes.
  Double4 step(const Four& length) {
    return sum_forward([&](std::uint32_t i) {
      solution_[i] += length * direction_[i];
      residual_[i] -= length * product_[i];
      return as_doubles(residual_[i]) * as_doubles(residual_[i]);
    });
  }

  std::uint32_t iterate(std::uint32_t most_iterations) {
    Double4 energy = begin();
    const Double4 small = reduction_ * reduction_ * energy;
    Four share{};
    for (std::uint32_t iteration = 1;; ++iteration) {
      turn(share);
      const Double4 left = step(as_four(ratio(energy, multiply())));
      if (all_at_most(left, small) || iteration >= most_iterations) return iteration;
      share = as_four(ratio(left, energy));
      energy = left;
    }
  }

  double reduction_;
  PartedOrder order_;        ///< what i means below
  std::vector<Node> nodes_;  ///< and one for the end
  LargeVector<Pair> pairs_;
  std::vector<Four> solution_, residual_;  ///< scaled x; y
  std::vector<Four> direction_, turned_;   ///< d and (I + L^T) d
  std::vector<Four> product_;              ///< (I + L)^-1 A d
  std::vector<Four> image_;                ///< by node: B times what the nodes come to so far have
};

}  // namespace

std::unique_ptr<ConjugateGradients> make_conjugate_gradients(const CoarsestNodes& nodes, double reduction) {
  if (reduction >= kFloatsReduce) return std::make_unique<Iterations<Float4>>(nodes, reduction);
  return std::make_unique<Iterations<Double4>>(nodes, reduction);
}

}  // namespace deltamesh::settling
