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

Double4 to_double4(const Vec3& v) noexcept { return {TwoDoubles{v[0], v[1]}, TwoDoubles{v[2], 0}}; }

/// Axis by axis; 0 where b is not above 0.
Double4 ratio(const Double4& a, const Double4& b) noexcept {
  const auto divide = [](double p, double q) { return q > 0 ? p / q : 0.0; };
  return {TwoDoubles{divide(a.xy[0], b.xy[0]), divide(a.xy[1], b.xy[1])},
          TwoDoubles{divide(a.zw[0], b.zw[0]), 0.0}};
}

double sum(const Double4& v) noexcept { return v.xy[0] + v.xy[1] + v.zw[0]; }

/// Of the axes that have a tenth of the proposal's energy.
double largest_mismatch(const Double4& length, const Double4& energy) noexcept {
  const double much = 0.1 * sum(energy);
  double largest = 0;
  const auto see = [&](double taken, double own) {
    if (own > much) largest = std::max(largest, std::abs(taken - 1));
  };
  see(length.xy[0], energy.xy[0]);
  see(length.xy[1], energy.xy[1]);
  see(length.zw[0], energy.zw[0]);
  return largest;
}

}  // namespace

Steps::Steps(const Adjacency& graph, const Components& components, std::span<const std::uint32_t> anchors,
             const DeltaView& deltas, std::span<const Vec3> targets, double unit)
    : graph_(graph),
      components_(components),
      anchors_(anchors),
      x_(graph.vertex_count(), Double4{}),
      s_(graph.vertex_count(), Double4{}),
      residual_(graph.vertex_count()),
      forces_(anchors.size()),
      last_{x_, x_, x_, forces_, std::vector<Double4>(components.count)},
      image_(graph.vertex_count()),
      progress_(components.count) {
  for (std::uint32_t i = 0; i < residual_.size(); ++i) {
    const Double4 delta = (1 / unit) * to_double4(deltas[i]);
    residual_[i] = (1.0 / graph.degree(i)) * delta;
    progress_[components.label[i]].functional += sum(delta * delta);
  }
  for (std::size_t a = 0; a < anchors.size(); ++a) {
    gaps_.push_back((1 / unit) * to_double4(targets[a]));
    progress_[components.label[anchors[a]]].functional += sum(gaps_[a] * gaps_[a]);
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
  std::vector<Sums> sums(components_.count);
  for_each_run(components_, [&](std::uint32_t begin, std::uint32_t end, std::uint32_t component) {
    Sums run{};
    for (std::uint32_t i = begin; i < end; ++i) {
      Double4 around{};
      for (const std::uint32_t j : graph_.of(i)) around += widen(problem.u[j].x);
      const double d = graph_.degree(i);
      const Double4 image = widen(problem.u[i].x) - (1 / d) * around;  // L x
      image_[i] = (1 / d) * image;
      run.own += image * image;
      run.cross += d * image * last_.image[i];
      run.gain += d * image * residual_[i];
    }
    sums[component].own += run.own;
    sums[component].cross += run.cross;
    sums[component].gain += run.gain;
  });
  for (std::size_t a = 0; a < anchors_.size(); ++a) {
    const Double4 x = widen(problem.u[anchors_[a]].x);
    Sums& own = sums[components_.label[anchors_[a]]];
    own.own += x * x;
    own.cross += x * last_.x[anchors_[a]];
    own.gain += x * gaps_[a];
  }
  return sums;
}

void Steps::take(const Vectors& problem) {
  const std::vector<Sums> sums = add_up(problem);
  std::vector<Double4> share, length;
  for (std::uint32_t c = 0; c < components_.count; ++c) {
    share.push_back(ratio(sums[c].cross, last_.energy[c]));
    last_.energy[c] = sums[c].own - share[c] * sums[c].cross;
    length.push_back(ratio(sums[c].gain, last_.energy[c]));
    const double decrease = sum(length[c] * sums[c].gain);
    progress_[c] = {.functional = std::max(progress_[c].functional - decrease, 0.0),
                    .decrease = decrease,
                    .proposed = sum(sums[c].own),
                    .mismatch = largest_mismatch(length[c], sums[c].own)};
  }
  for_each_run(components_, [&](std::uint32_t begin, std::uint32_t end, std::uint32_t c) {
    const Double4 taken = length[c];
    const Double4 kept = share[c];
    for (std::uint32_t i = begin; i < end; ++i) {
      last_.x[i] = widen(problem.u[i].x) - kept * last_.x[i];
      last_.s[i] = widen(problem.u[i].s) - kept * last_.s[i];
      last_.image[i] = image_[i] - kept * last_.image[i];
      x_[i] += taken * last_.x[i];
      s_[i] += taken * last_.s[i];
      residual_[i] -= taken * last_.image[i];
    }
  });
  for (std::size_t a = 0; a < anchors_.size(); ++a) {
    const std::uint32_t c = components_.label[anchors_[a]];
    last_.forces[a] = widen(problem.forces[a]) - share[c] * last_.forces[a];
    forces_[a] += length[c] * last_.forces[a];
    gaps_[a] -= length[c] * last_.x[anchors_[a]];
  }
}

}  // namespace deltamesh::settling
