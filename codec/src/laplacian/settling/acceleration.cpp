// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/acceleration.h"

#include <algorithm>

namespace deltamesh::settling {
namespace {

using Sums = std::array<double, 3>;

void add_product(Sums& sums, Float4 a, Float4 b) noexcept {
  for (int axis = 0; axis < 3; ++axis)
    sums[static_cast<std::size_t>(axis)] += static_cast<double>(a[axis]) * static_cast<double>(b[axis]);
}

/// Component by component and axis by axis, a / b; 0 where b is.
void divide(std::span<const Sums> a, std::span<const Sums> b, std::span<Float4> ratio) noexcept {
  for (std::size_t c = 0; c < ratio.size(); ++c) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      ratio[c][axis] = b[c][k] > 0 ? static_cast<float>(a[c][k] / b[c][k]) : 0.0F;
    }
  }
}

}  // namespace

Acceleration::Acceleration(const Group& group)
    : group_(group),
      directions_(kDirections),
      proposed_(group.components.count),
      before_(group.vertex_count()),
      forces_before_(group.anchors.size()),
      residual_(group.vertex_count()),
      anchor_residual_(group.anchors.size()) {
  for (Direction& direction : directions_) {
    direction.step.resize(group.vertex_count());
    direction.image.resize(group.vertex_count());
    direction.forces.resize(group.anchors.size());
    direction.energy.resize(group.components.count);
    direction.overlap.resize(group.components.count);
    direction.share.resize(group.components.count);
  }
}

void Acceleration::restart(CoupledCycle& cycles) {
  for (std::uint32_t i = 0; i < residual_.size(); ++i)
    residual_[i] = 1.0F / static_cast<float>(group_.graph->degree(i)) * cycles.delta(i);
  for (std::size_t a = 0; a < anchor_residual_.size(); ++a) anchor_residual_[a] = cycles.target(a);
}

void Acceleration::take_step(CoupledCycle& cycles, Direction& direction) {
  const std::span<Row> u = cycles.solution();
  std::copy(u.begin(), u.end(), before_.begin());
  for (std::size_t a = 0; a < forces_before_.size(); ++a) forces_before_[a] = cycles.force(a);
  cycles.cycle();
  std::fill(proposed_.begin(), proposed_.end(), Change{});
  for (std::size_t i = 0; i < u.size(); ++i) {
    direction.step[i] = {u[i].x - before_[i].x, u[i].s - before_[i].s};
    Sums squares{};
    add_product(squares, direction.step[i].x, direction.step[i].x);
    const double square = squares[0] + squares[1] + squares[2];
    Change& change = proposed_[group_.components.label[i]];
    change.squares += square;
    change.largest = std::max(change.largest, square);
  }
  for (std::size_t a = 0; a < forces_before_.size(); ++a)
    direction.forces[a] = cycles.force(a) - forces_before_[a];
}

void Acceleration::apply_laplacian(Direction& direction) const {
  for (std::uint32_t i = 0; i < direction.image.size(); ++i) {
    Float4 sum{};
    for (const std::uint32_t j : group_.graph->of(i)) sum += direction.step[j].x;
    direction.image[i] = direction.step[i].x - 1.0F / static_cast<float>(group_.graph->degree(i)) * sum;
  }
}

void Acceleration::orthogonalize(Direction& direction) {
  const auto& label = group_.components.label;
  const std::size_t kept = std::min(count_, kDirections - 1);
  for (std::size_t k = 0; k < kept; ++k) {
    Direction& other = directions_[(count_ - 1 - k) % kDirections];
    std::fill(other.overlap.begin(), other.overlap.end(), Sums{});
    for (std::size_t i = 0; i < label.size(); ++i)
      add_product(other.overlap[label[i]], direction.image[i], other.image[i]);
    for (const std::uint32_t anchor : group_.anchors)
      add_product(other.overlap[label[anchor]], direction.step[anchor].x, other.step[anchor].x);
    divide(other.overlap, other.energy, other.share);
    for (std::size_t i = 0; i < label.size(); ++i) {
      const Float4 share = other.share[label[i]];
      direction.image[i] -= share * other.image[i];
      direction.step[i].x -= share * other.step[i].x;
      direction.step[i].s -= share * other.step[i].s;
    }
    for (std::size_t a = 0; a < direction.forces.size(); ++a)
      direction.forces[a] -= other.share[label[group_.anchors[a]]] * other.forces[a];
  }
}

void Acceleration::move(CoupledCycle& cycles, Direction& direction) {
  const auto& label = group_.components.label;
  std::fill(direction.energy.begin(), direction.energy.end(), Sums{});
  std::fill(direction.overlap.begin(), direction.overlap.end(), Sums{});
  for (std::size_t i = 0; i < label.size(); ++i) {
    add_product(direction.energy[label[i]], direction.image[i], direction.image[i]);
    add_product(direction.overlap[label[i]], direction.image[i], residual_[i]);
  }
  for (std::size_t a = 0; a < anchor_residual_.size(); ++a) {
    const Float4 step = direction.step[group_.anchors[a]].x;
    add_product(direction.energy[label[group_.anchors[a]]], step, step);
    add_product(direction.overlap[label[group_.anchors[a]]], step, anchor_residual_[a]);
  }
  divide(direction.overlap, direction.energy, direction.share);

  const std::span<Row> u = cycles.solution();
  for (std::size_t i = 0; i < label.size(); ++i) {
    const Float4 share = direction.share[label[i]];
    u[i] = {before_[i].x + share * direction.step[i].x, before_[i].s + share * direction.step[i].s};
    residual_[i] -= share * direction.image[i];
  }
  for (std::size_t a = 0; a < anchor_residual_.size(); ++a) {
    const Float4 share = direction.share[label[group_.anchors[a]]];
    cycles.force(a) = forces_before_[a] + share * direction.forces[a];
    anchor_residual_[a] -= share * direction.step[group_.anchors[a]].x;
  }
}

void Acceleration::cycle(CoupledCycle& cycles) {
  Direction& direction = directions_[count_ % kDirections];
  take_step(cycles, direction);
  apply_laplacian(direction);
  orthogonalize(direction);
  move(cycles, direction);
  ++count_;
}

}  // namespace deltamesh::settling
