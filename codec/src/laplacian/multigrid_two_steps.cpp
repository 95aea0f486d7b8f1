// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid_two_steps.h"

#include <algorithm>

namespace deltamesh::multigrid {
namespace {

/// Part of the second cycle's energy that must be left beside the first one's, else it is rounding.
constexpr double kFewestNews = 1e-6;

/// Axis by axis a / b; 0 where b is not above `least`.
Double4 ratio(const Double4& a, const Double4& b, const Double4& least) noexcept {
  const auto divide = [](double p, double q, double r) { return q > r ? p / q : 0.0; };
  return {TwoDoubles{divide(a.xy[0], b.xy[0], least.xy[0]), divide(a.xy[1], b.xy[1], least.xy[1])},
          TwoDoubles{divide(a.zw[0], b.zw[0], least.zw[0]), 0.0}};
}

float inverse_mass(const Level& level, std::uint32_t i) noexcept {
  return level.mass[i] > 0 ? 1 / level.mass[i] : 0.0F;
}

}  // namespace

TwoSteps::TwoSteps(const Level& level)
    : first_(level.node_count()), image_(level.node_count()), forces_(level.anchors.size()) {}

void TwoSteps::take_first(const LevelProblem& problem) {
  const Level& level = problem.level;
  const std::span<Row> u = problem.u;
  Double4 energy, gain;
  for (std::uint32_t i = 0; i < u.size(); ++i) {
    Row k{level.degree[i] * u[i].x, level.degree[i] * u[i].s};
    for (std::uint32_t e = level.offsets[i]; e < level.offsets[i + 1]; ++e) {
      const Row& other = u[level.neighbors[e]];
      k.x -= level.weight(e) * other.x;
      k.s -= level.weight(e) * other.s;
    }
    const Float4 scaled = inverse_mass(level, i) * k.x;
    energy += widen(scaled * k.x);
    gain += widen(scaled * problem.b[i].x - u[i].x * problem.b[i].s);
    image_[i] = {k.x + level.mass[i] * u[i].s, k.s};
  }
  for (std::size_t a = 0; a < forces_.size(); ++a) {
    const Float4 x = u[level.anchors[a]].x;
    energy += widen(x * x);
    gain += widen(x * (problem.gaps[a] + problem.forces[a]));  // b holds the forces already
  }
  energy_ = energy;
  length_ = ratio(gain, energy, Double4{});
  const Float4 length = narrow(length_);
  for (std::size_t i = 0; i < u.size(); ++i) {
    problem.b[i].x -= length * image_[i].x;
    problem.b[i].s -= length * image_[i].s;
    first_[i] = u[i];
  }
  for (std::size_t a = 0; a < forces_.size(); ++a) {
    const Float4 force = problem.forces[a];
    forces_[a] = force;
    problem.b[level.anchors[a]].s += length * force - force;
    problem.gaps[a] += length * (force - u[level.anchors[a]].x);
  }
}

void TwoSteps::combine(const LevelProblem& problem) {
  const Level& level = problem.level;
  const std::span<Row> u = problem.u;
  Double4 energy, overlap, gain;
  for (std::uint32_t i = 0; i < u.size(); ++i) {
    Float4 k = level.degree[i] * u[i].x;
    for (std::uint32_t e = level.offsets[i]; e < level.offsets[i + 1]; ++e)
      k -= level.weight(e) * u[level.neighbors[e]].x;
    const Float4 scaled = inverse_mass(level, i) * k;
    energy += widen(scaled * k);
    overlap += widen(scaled * (image_[i].x - level.mass[i] * first_[i].s));
    gain += widen(scaled * problem.b[i].x - u[i].x * problem.b[i].s);
  }
  for (std::size_t a = 0; a < forces_.size(); ++a) {
    const Float4 x = u[level.anchors[a]].x;
    energy += widen(x * x);
    overlap += widen(x * first_[level.anchors[a]].x);
    gain += widen(x * (problem.gaps[a] + problem.forces[a]));
  }
  const Double4 share = ratio(overlap, energy_, Double4{});
  const Double4 news = energy - share * overlap;
  const Double4 second = ratio(gain, news, kFewestNews * energy);
  const Float4 of_first = narrow(length_ - second * share);
  const Float4 of_second = narrow(second);
  for (std::size_t i = 0; i < u.size(); ++i) {
    u[i].x = of_first * first_[i].x + of_second * u[i].x;
    u[i].s = of_first * first_[i].s + of_second * u[i].s;
  }
  for (std::size_t a = 0; a < forces_.size(); ++a)
    problem.forces[a] = of_first * forces_[a] + of_second * problem.forces[a];
}

}  // namespace deltamesh::multigrid
