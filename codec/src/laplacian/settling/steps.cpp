// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/steps.h"

#include <algorithm>
#include <cmath>

#include "topology/subgraph.h"

namespace deltamesh::settling {
namespace {

using multigrid::narrow;
using multigrid::widen;
using Vectors = multigrid::LevelSolver::Vectors;

/// Of a proposal's energy: where less is new, that is rounding.
constexpr double kLeastEnergy = 0x1p-30;

Double4 to_double4(const Vec3& v, double probe) noexcept {
  return {TwoDoubles{v[0], v[1]}, TwoDoubles{v[2], probe}};
}

/// 1 or -1, by chance but the same always: the top bit of a multiplicative hash.
double random_sign(std::uint64_t i) noexcept {
  std::uint64_t z = (i + 1) * 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  return (z >> 63) != 0 ? 1.0 : -1.0;
}

/// Axis by axis a; 0 where it is not above b.
Double4 above(const Double4& a, const Double4& b) noexcept {
  const auto pick = [](double p, double q) { return p > q ? p : 0.0; };
  return {TwoDoubles{pick(a.xy[0], b.xy[0]), pick(a.xy[1], b.xy[1])},
          TwoDoubles{pick(a.zw[0], b.zw[0]), pick(a.zw[1], b.zw[1])}};
}

}  // namespace

Steps::Steps(const Problem& problem, double unit)
    : graph_(problem.graph),
      components_(problem.components),
      anchors_(problem.anchors),
      x_(graph_.vertex_count(), Double4{}),
      s_(graph_.vertex_count(), Double4{}),
      residual_(graph_.vertex_count()),
      forces_(anchors_.size()),
      image_(graph_.vertex_count()),
      progress_(components_.count) {
  for (Direction& last : last_) last = {x_, x_, x_, forces_, std::vector<Double4>(components_.count)};
  for (std::uint32_t i = 0; i < residual_.size(); ++i) {
    const Double4 delta = to_double4((1 / unit) * problem.deltas[i], random_sign(i));
    residual_[i] = (1.0 / graph_.degree(i)) * delta;
    progress_[components_.label[i]].functional += sum_of_axes(delta * delta);
  }
  for (std::size_t a = 0; a < anchors_.size(); ++a) {
    gaps_.push_back(to_double4((1 / unit) * problem.targets[a], 0));
    progress_[components_.label[anchors_[a]]].functional += sum_of_axes(gaps_[a] * gaps_[a]);
  }
}

void Steps::set_residual(Vectors& problem) const {
  for (std::uint32_t i = 0; i < x_.size(); ++i) {
    Double4 around{};
    for (const std::uint32_t j : graph_.of(i)) around += s_[j];
    const double d = graph_.degree(i);
    problem.b[i] = {narrow(d * d * (residual_[i] - s_[i])), narrow(around - d * s_[i])};
  }
  for (std::size_t a = 0; a < anchors_.size(); ++a) {
    problem.b[anchors_[a]].s += narrow(forces_[a]);
    problem.gaps[a] = narrow(gaps_[a] + forces_[a]);
  }
}

/// Per component; the proposal's image as well.
std::vector<Steps::Sums> Steps::add_up(const Vectors& problem) {
  const std::size_t known = std::min(taken_, kDirections);
  std::vector<Sums> sums(components_.count);
  for_each_run(components_, [&](std::uint32_t begin, std::uint32_t end, std::uint32_t component) {
    Sums run{};
    for (std::uint32_t i = begin; i < end; ++i) {
      Double4 around{};
      for (const std::uint32_t j : graph_.of(i)) around += widen(problem.u[j].x);
      const double d = graph_.degree(i);
      const Double4 x = widen(problem.u[i].x);
      const Double4 image = x - (1 / d) * around;  // L x
      image_[i] = (1 / d) * image;
      run.own += image * image;
      run.x += x * x;
      for (std::size_t k = 0; k < known; ++k) run.cross[k] += d * image * last_[k].image[i];
      run.gain += d * image * residual_[i];
    }
    sums[component].own += run.own;
    for (std::size_t k = 0; k < known; ++k) sums[component].cross[k] += run.cross[k];
    sums[component].gain += run.gain;
    sums[component].x += run.x;
  });
  for (std::size_t a = 0; a < anchors_.size(); ++a) {
    const Double4 x = widen(problem.u[anchors_[a]].x);
    Sums& own = sums[components_.label[anchors_[a]]];
    own.own += x * x;
    for (std::size_t k = 0; k < known; ++k) own.cross[k] += x * last_[k].x[anchors_[a]];
    own.gain += x * gaps_[a];
  }
  return sums;
}

void Steps::take(const Vectors& problem) {
  const std::vector<Sums> sums = add_up(problem);
  const std::size_t known = std::min(taken_, kDirections);
  Direction& direction = last_[taken_ % kDirections];
  std::vector<PerDirection> share(components_.count);
  std::vector<Double4> length(components_.count);
  for (std::uint32_t c = 0; c < components_.count; ++c) {
    Double4 energy = sums[c].own;
    for (std::size_t k = 0; k < known; ++k) {
      share[c][k] = ratio(sums[c].cross[k], last_[k].energy[c]);
      energy -= share[c][k] * sums[c].cross[k];
    }
    direction.energy[c] = energy = above(energy, kLeastEnergy * sums[c].own);
    length[c] = ratio(sums[c].gain, energy);
    const double decrease = sum_of_axes(length[c] * sums[c].gain);
    progress_[c] = {.functional = std::max(progress_[c].functional - decrease, 0.0),
                    .decrease = decrease,
                    .proposed = sums[c].x};
  }
  take_vertices(problem, share, length, direction);
  for (std::size_t a = 0; a < anchors_.size(); ++a) {
    const std::uint32_t c = components_.label[anchors_[a]];
    Double4 force = widen(problem.forces[a]);
    for (std::size_t k = 0; k < known; ++k) force -= share[c][k] * last_[k].forces[a];
    direction.forces[a] = force;
    forces_[a] += length[c] * force;
    gaps_[a] -= length[c] * direction.x[anchors_[a]];
  }
  ++taken_;
}

/// `direction`: one of the last, overwritten.
void Steps::take_vertices(const Vectors& problem, std::span<const PerDirection> share,
                          std::span<const Double4> length, Direction& direction) {
  const std::size_t known = std::min(taken_, kDirections);
  for_each_run(components_, [&](std::uint32_t begin, std::uint32_t end, std::uint32_t c) {
    Double4 change{};
    double probe = 0;
    for (std::uint32_t i = begin; i < end; ++i) {
      Double4 x = widen(problem.u[i].x);
      Double4 s = widen(problem.u[i].s);
      Double4 image = image_[i];
      for (std::size_t k = 0; k < known; ++k) {
        x -= share[c][k] * last_[k].x[i];
        s -= share[c][k] * last_[k].s[i];
        image -= share[c][k] * last_[k].image[i];
      }
      direction.x[i] = x;
      direction.s[i] = s;
      direction.image[i] = image;
      const Double4 step = length[c] * x;
      x_[i] += step;
      s_[i] += length[c] * s;
      residual_[i] -= length[c] * image;
      change += step * step;
      probe += x_[i].zw[1] * x_[i].zw[1];
    }
    progress_[c].taken += change;
    progress_[c].probe += probe;
  });
}

}  // namespace deltamesh::settling
