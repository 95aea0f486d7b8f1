// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/steps.h"

namespace deltamesh {
namespace {

Vec3 product(const Vec3& a, const Vec3& b) noexcept { return {a[0] * b[0], a[1] * b[1], a[2] * b[2]}; }

/// Axis by axis; 0 where b is not above 0.
Vec3 ratio(const Vec3& a, const Vec3& b) noexcept {
  const auto divide = [](double p, double q) { return q > 0 ? p / q : 0.0; };
  return {divide(a[0], b[0]), divide(a[1], b[1]), divide(a[2], b[2])};
}

Vec3 sum_of(std::span<const std::uint32_t> neighbors, std::span<const Vec3> values) noexcept {
  Vec3 sum{};
  for (const std::uint32_t neighbor : neighbors) sum = sum + values[neighbor];
  return sum;
}

}  // namespace

Steps::Steps(const Adjacency& graph, const Components& components, std::span<const std::uint32_t> anchors,
             const DeltaView& deltas, std::span<const Vec3> targets)
    : graph_(graph),
      components_(components),
      anchors_(anchors),
      residual_(graph.vertex_count()),
      gaps_(targets.begin(), targets.end()) {
  for (std::size_t i = 0; i < residual_.size(); ++i) residual_[i] = deltas[i];
  for (Direction& direction : directions_) {
    direction.step.resize(residual_.size());
    direction.image.resize(residual_.size());
    direction.energy.resize(components.count);
  }
}

/// Per component, vertex(i) of all its vertices and anchor(a, vertex) of all its anchors.
template <class Vertex, class Anchor>
std::vector<Vec3> Steps::sum_up(const Vertex& vertex, const Anchor& anchor) const {
  std::vector<Vec3> sums(components_.count, Vec3{});
  for (std::size_t i = 0; i < residual_.size(); ++i) {
    Vec3& sum = sums[components_.label[i]];
    sum = sum + vertex(i);
  }
  for (std::size_t a = 0; a < anchors_.size(); ++a) {
    Vec3& sum = sums[components_.label[anchors_[a]]];
    sum = sum + anchor(a, anchors_[a]);
  }
  return sums;
}

void Steps::propose_gradient() {
  const std::span<Vec3> step = proposed();
  std::vector<double> diagonal(step.size(), 1.0);
  std::vector<Vec3> shares(step.size());  // D^-1 residual
  for (std::uint32_t i = 0; i < step.size(); ++i) {
    const double share = 1.0 / graph_.degree(i);
    shares[i] = share * residual_[i];
    for (const std::uint32_t neighbor : graph_.of(i)) diagonal[neighbor] += share * share;
  }
  for (const std::uint32_t anchor : anchors_) diagonal[anchor] += 1;
  for (std::uint32_t i = 0; i < step.size(); ++i) step[i] = residual_[i] - sum_of(graph_.of(i), shares);
  for (std::size_t a = 0; a < anchors_.size(); ++a) step[anchors_[a]] = step[anchors_[a]] + gaps_[a];
  for (std::uint32_t i = 0; i < step.size(); ++i) step[i] = 1 / diagonal[i] * step[i];
}

void Steps::make_orthogonal(Direction& direction, const Direction& other) const {
  std::vector<Vec3> share =
      sum_up([&](std::size_t i) { return product(direction.image[i], other.image[i]); },
             [&](std::size_t, std::uint32_t v) { return product(direction.step[v], other.step[v]); });
  for (std::size_t c = 0; c < share.size(); ++c) share[c] = ratio(share[c], other.energy[c]);
  for (std::size_t i = 0; i < direction.step.size(); ++i) {
    const Vec3& own = share[components_.label[i]];
    direction.image[i] = direction.image[i] - product(own, other.image[i]);
    direction.step[i] = direction.step[i] - product(own, other.step[i]);
  }
}

void Steps::take(std::span<Vec3> x) {
  Direction& direction = directions_[count_ % 2];
  for (std::uint32_t i = 0; i < x.size(); ++i)
    direction.image[i] = direction.step[i] - 1.0 / graph_.degree(i) * sum_of(graph_.of(i), direction.step);
  if (count_ > 0) make_orthogonal(direction, directions_[(count_ - 1) % 2]);
  direction.energy =
      sum_up([&](std::size_t i) { return product(direction.image[i], direction.image[i]); },
             [&](std::size_t, std::uint32_t v) { return product(direction.step[v], direction.step[v]); });
  std::vector<Vec3> length =
      sum_up([&](std::size_t i) { return product(direction.image[i], residual_[i]); },
             [&](std::size_t a, std::uint32_t v) { return product(direction.step[v], gaps_[a]); });
  for (std::size_t c = 0; c < length.size(); ++c) length[c] = ratio(length[c], direction.energy[c]);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vec3& own = length[components_.label[i]];
    x[i] = x[i] + product(own, direction.step[i]);
    residual_[i] = residual_[i] - product(own, direction.image[i]);
  }
  for (std::size_t a = 0; a < gaps_.size(); ++a) {
    const std::uint32_t v = anchors_[a];
    gaps_[a] = gaps_[a] - product(length[components_.label[v]], direction.step[v]);
  }
  ++count_;
}

}  // namespace deltamesh
