// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/coarsest/conjugate_gradients.h"

#include <algorithm>
#include <cmath>

namespace deltamesh::multigrid {
namespace {

/// The coarsest level has a few nodes for each anchor: so many get near its solution.
constexpr int kIterations = 12;

}  // namespace

ConjugateGradients::ConjugateGradients(const Level& level, std::span<const double> inverse_mass) {
  const std::uint32_t n = level.node_count();
  std::vector<double> is_anchor(n, 0.0);
  for (const std::uint32_t anchor : level.anchors) is_anchor[anchor] = 1;
  entries_.reserve(n + level.neighbors.size());
  for (std::uint32_t node = 0; node < n; ++node) add_node(level, inverse_mass, is_anchor[node], node);
  nodes_.push_back({static_cast<std::uint32_t>(entries_.size()), 0, 0});
  for (auto* vector : {&residual_, &direction_, &turned_, &product_, &image_}) vector->resize(n);
}

void ConjugateGradients::add_node(const Level& level, std::span<const double> inverse_mass, double anchor,
                                  std::uint32_t node) {
  const auto visit_k = [&](const auto& each) {
    each(node, static_cast<double>(level.degree[node]));
    for (std::uint32_t e = level.offsets[node]; e < level.offsets[node + 1]; ++e)
      each(level.neighbors[e], -static_cast<double>(level.weights[e]));
  };
  double diagonal = anchor;
  visit_k([&](std::uint32_t row, double k) { diagonal += k * k * inverse_mass[row]; });
  const double scale = diagonal > 0 ? 1 / std::sqrt(diagonal) : 0;
  nodes_.push_back({static_cast<std::uint32_t>(entries_.size()), anchor * scale * scale, scale});
  visit_k([&](std::uint32_t row, double k) {
    entries_.push_back({row, k * scale * std::sqrt(inverse_mass[row])});
  });
}

std::span<const ConjugateGradients::Entry> ConjugateGradients::column(std::size_t i) const noexcept {
  return {entries_.data() + nodes_[i].first, entries_.data() + nodes_[i + 1].first};
}

/// Of B^T times the image.
Double4 ConjugateGradients::row_of_image(std::size_t i) const noexcept {
  Double4 sum{};
  for (const auto& [row, value] : column(i)) sum += value * image_[row];
  return sum;
}

/// What z at a node adds to the image.
void ConjugateGradients::add_to_image(std::size_t i, const Double4& z) noexcept {
  for (const auto& [row, value] : column(i)) image_[row] += value * z;
}

/// y for the right-hand side x, which becomes 0; returns its square.
Double4 ConjugateGradients::begin(std::span<Double4> x) {
  Double4 energy{};
  std::fill(image_.begin(), image_.end(), Double4{});
  for (std::size_t i = 0; i < x.size(); ++i) {
    residual_[i] = nodes_[i].scale * x[i] - row_of_image(i);
    add_to_image(i, residual_[i]);
    energy += residual_[i] * residual_[i];
  }
  std::fill(x.begin(), x.end(), Double4{});
  std::fill(turned_.begin(), turned_.end(), Double4{});
  return energy;
}

/// The direction becomes the preconditioned residual and `share` of what it was, the image its own.
void ConjugateGradients::turn(const Double4& share) {
  std::fill(image_.begin(), image_.end(), Double4{});
  for (std::size_t i = turned_.size(); i-- > 0;) {
    turned_[i] = residual_[i] + share * turned_[i];
    direction_[i] = turned_[i] - row_of_image(i);
    add_to_image(i, direction_[i]);
  }
}

/// (I + L)^-1 A d from the direction's image, which is used up; returns d A d.
Double4 ConjugateGradients::multiply() {
  Double4 energy{};
  for (std::size_t i = 0; i < product_.size(); ++i) {
    product_[i] = row_of_image(i) + nodes_[i].anchor * direction_[i];
    add_to_image(i, -1.0 * product_[i]);
    energy += turned_[i] * product_[i];
  }
  return energy;
}

/// Returns the square of what y becomes.
Double4 ConjugateGradients::step(const Double4& length, std::span<Double4> x) {
  Double4 energy{};
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] += length * direction_[i];
    residual_[i] -= length * product_[i];
    energy += residual_[i] * residual_[i];
  }
  return energy;
}

void ConjugateGradients::solve(std::span<Double4> x) {
  Double4 energy = begin(x);
  Double4 share{};
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    turn(share);
    const Double4 left = step(ratio(energy, multiply()), x);
    share = ratio(left, energy);
    energy = left;
  }
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = nodes_[i].scale * x[i];
}

}  // namespace deltamesh::multigrid
