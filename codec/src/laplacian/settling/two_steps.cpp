// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/two_steps.h"

#include <array>
#include <span>

#include "laplacian/settling/edges.h"

namespace deltamesh::settling {
namespace {

/// Part of the second cycle's energy that must be left beside the first one's, else it is rounding.
constexpr double kFewestNews = 1e-6;

/// Axis by axis a / b; 0 where b is not above `least`.
Double4 ratio(const Double4& a, const Double4& b, const Double4& least) noexcept {
  const auto divide = [](double p, double q, double r) { return q > r ? p / q : 0.0; };
  return {TwoDoubles{divide(a.xy[0], b.xy[0], least.xy[0]), divide(a.xy[1], b.xy[1], least.xy[1])},
          TwoDoubles{divide(a.zw[0], b.zw[0], least.zw[0]), 0.0}};
}

struct Sums {
  Double4 energy{};
  Double4 overlap{};
  Double4 gain{};
};

/// What add(node, sums) adds for all nodes: chunk by chunk, so that threads make no difference.
template <class Add>
Sums sum_up(const Chunks& chunks, const Add& add) {
  std::array<Sums, kMostChunks> parts{};
  for (std::uint32_t chunk = 0; chunk < chunks.count(); ++chunk) {
    Sums sums;
    for (std::uint32_t i = chunks.bounds[chunk]; i < chunks.bounds[chunk + 1]; ++i) add(i, sums);
    parts[chunk] = sums;
  }
  Sums total;
  for (const Sums& part : std::span(parts).first(chunks.count())) {
    total.energy += part.energy;
    total.overlap += part.overlap;
    total.gain += part.gain;
  }
  return total;
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
  const Edges edges(level);
  Sums sums = sum_up(level.chunks, [&](std::uint32_t i, Sums& add) {
    const Row around = edges.add_pairs(
        level.offsets[i], level.offsets[i + 1], [&](std::uint32_t other) { return u[other]; }, Row{});
    const Row k{level.degree[i] * u[i].x - around.x, level.degree[i] * u[i].s - around.s};
    const Float4 scaled = inverse_mass(level, i) * k.x;
    add.energy += widen(scaled * k.x);
    add.gain += widen(scaled * problem.b[i].x - u[i].x * problem.b[i].s);
    image_[i] = {k.x + level.mass[i] * u[i].s, k.s};
  });
  for (std::size_t a = 0; a < forces_.size(); ++a) {
    const Float4 x = u[level.anchors[a]].x;
    sums.energy += widen(x * x);
    sums.gain += widen(x * (problem.gaps[a] + problem.forces[a]));  // b holds the forces already
  }
  energy_ = sums.energy;
  length_ = ratio(sums.gain, sums.energy, Double4{});
  const Float4 length = narrow(length_);
  for (std::uint32_t i = 0; i < u.size(); ++i) {
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
  const Edges edges(level);
  Sums sums = sum_up(level.chunks, [&](std::uint32_t i, Sums& add) {
    const Float4 k = level.degree[i] * u[i].x - edges.add_x(i, u.data(), Float4{});
    const Float4 scaled = inverse_mass(level, i) * k;
    add.energy += widen(scaled * k);
    add.overlap += widen(scaled * (image_[i].x - level.mass[i] * first_[i].s));
    add.gain += widen(scaled * problem.b[i].x - u[i].x * problem.b[i].s);
  });
  for (std::size_t a = 0; a < forces_.size(); ++a) {
    const Float4 x = u[level.anchors[a]].x;
    sums.energy += widen(x * x);
    sums.overlap += widen(x * first_[level.anchors[a]].x);
    sums.gain += widen(x * (problem.gaps[a] + problem.forces[a]));
  }
  const Double4 share = ratio(sums.overlap, energy_, Double4{});
  const Double4 news = sums.energy - share * sums.overlap;
  const Double4 second = ratio(sums.gain, news, kFewestNews * sums.energy);
  const Float4 of_first = narrow(length_ - second * share);
  const Float4 of_second = narrow(second);
  for (std::uint32_t i = 0; i < u.size(); ++i) {
    u[i].x = of_first * first_[i].x + of_second * u[i].x;
    u[i].s = of_first * first_[i].s + of_second * u[i].s;
  }
  for (std::size_t a = 0; a < forces_.size(); ++a)
    problem.forces[a] = of_first * forces_[a] + of_second * problem.forces[a];
}

}  // namespace deltamesh::settling
