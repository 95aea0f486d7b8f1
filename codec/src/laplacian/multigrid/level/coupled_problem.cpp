// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid/level/coupled_problem.h"

#include <cstddef>

#include "base/threads/thread_team.h"
#include "laplacian/multigrid/level/edges.h"

namespace deltamesh::multigrid {

Float4 best_length(const CoupledProblem& problem, std::span<Row> image) {
  const Level& level = problem.level;
  const std::span<const Row> u = problem.u;
  const Edges edges(level);
  Double4 energy{};
  Double4 gain{};
  for (std::uint32_t i = 0; i < level.node_count(); ++i) {
    const Row around = edges.sum_all(i, [&](std::uint32_t other) { return u[other]; });
    const Row k{level.degree[i] * u[i].x - around.x, level.degree[i] * u[i].s - around.s};
    const Float4 scaled = 1 / level.mass[i] * k.x;
    energy += widen(scaled * k.x);
    gain += widen(scaled * problem.b[i].x - u[i].x * problem.b[i].s);
    if (!image.empty()) image[i] = {k.x + level.mass[i] * u[i].s, k.s};
  }
  for (std::size_t a = 0; a < problem.gaps.size(); ++a) {
    const Float4 x = u[level.anchors[a]].x;
    energy += widen(x * x);
    gain += widen(x * (problem.gaps[a] + problem.forces[a]));  // b.s holds the forces already
  }
  const auto divide = [](double p, double q) { return static_cast<float>(q > 0 ? p / q : 0.0); };
  return Float4{divide(gain.xy[0], energy.xy[0]), divide(gain.xy[1], energy.xy[1]),
                divide(gain.zw[0], energy.zw[0]), 0};
}

void take_off(const CoupledProblem& problem, Float4 length, std::span<const Row> image, ThreadTeam* team) {
  const Level& level = problem.level;
  share_each(team, image.size(), [&](std::uint32_t i) {
    problem.b[i].x -= length * image[i].x;
    problem.b[i].s -= length * image[i].s;
  });
  for (std::size_t a = 0; a < problem.gaps.size(); ++a) {
    const Float4 force = problem.forces[a];
    problem.b[level.anchors[a]].s += length * force - force;
    problem.gaps[a] += length * (force - problem.u[level.anchors[a]].x);
  }
}

}  // namespace deltamesh::multigrid
