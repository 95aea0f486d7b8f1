// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid/cycle/planned_cycles.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "base/threads/thread_team.h"
#include "laplacian/multigrid/level/edges.h"
#include "laplacian/multigrid/level/row.h"
#include "laplacian/multigrid/level/unit_edges.h"

namespace deltamesh::multigrid {
namespace {

/// Over-relaxation of the finest level's sweeps in a cycle, and after the last one, as interpolation leaves x
/// rough. Measured: more than 1 at first is for the slow errors, less at the end for the rough ones.
constexpr std::array kSweeps = {1.3F, 1.0F};
constexpr std::array kLastSweeps = {1.0F, 1.0F};

/// What interpolation finds of rows.
struct PositionsOf {
  std::span<const Row> rows;
  Float4 operator[](std::uint32_t node) const noexcept { return rows[node].x; }
};

/// Of `deltas`.
Float4 in_steps(const Vec3& v, const DeltaView& deltas) noexcept {
  const double step = deltas.scale().step;
  return to_float4({v[0] / step, v[1] / step, v[2] / step});
}

/// Of all axes, in size; not finite where one is not.
float largest_coordinate(std::span<const Row> rows) noexcept {
  Float4 largest{};
  Float4 nothing{};  // the sum of what is 0 where values are finite, else not a number
  for (const Row& row : rows) {
    const Float4 size = row.x < 0 ? -row.x : row.x;
    largest = size > largest ? size : largest;
    nothing += 0 * row.x;
  }
  return std::max({largest[0], largest[1], largest[2]}) + (nothing[0] + nothing[1] + nothing[2]);
}

/// One Gauss-Seidel sweep per entry of `relaxation`, which is its over-relaxation factor. A sweep's step
/// obeys the same equations as the correction that it is part of, with no right-hand side: neither that nor
/// the first residual is needed again. The first sweep computes `step` from residual(node, row), called once
/// for every node in ascending order; keep(node, step) is called after each step and must apply it before the
/// next residual is asked for.
template <class Residual, class Keep>
void sweep(const UnitEdges& edges, std::span<const float> relaxation, const Residual& residual,
           std::span<Float4> step, const Keep& keep) {
  for (std::uint32_t i = 0; i < edges.node_count(); ++i) {
    edges.with_row(i, [&](const auto& row) {
      step[i] = relaxation[0] * row.inverse_degree() * residual(i, row);
      keep(i, step[i]);
    });
  }
  for (std::size_t s = 1; s < relaxation.size(); ++s) {
    const float by = relaxation[s];
    const float own = (1 / relaxation[s - 1] - 1) * by;
    for (std::uint32_t i = 0; i < edges.node_count(); ++i) {
      edges.with_row(i, [&](const auto& row) {
        step[i] = row.add_scaled(step.data(), own * step[i], by * row.inverse_degree());
        keep(i, step[i]);
      });
    }
  }
}

/// Gives take(node, residual) what all sweeps leave, the last of them not over-relaxed.
template <class Take>
void take_residuals(const UnitEdges& edges, std::span<const Float4> step, const Take& take) {
  for (std::uint32_t i = 0; i < edges.node_count(); ++i)
    edges.with_row(i, [&](const auto& row) { take(i, row.upper(step.data())); });
}

}  // namespace

PlannedCycles::PlannedCycles(std::span<const Level> levels, ThreadTeam* team)
    : finest_(levels[0]),
      second_(levels[1]),
      coarse_(levels.subspan(1), team),
      step_(finest_.node_count() + 1),
      s_(second_.node_count()),
      forces_(finest_.anchors.size()),
      team_(team) {
  step_.back() = Float4{};  // what UnitEdges takes for neighbours that do not count
}

/// The second level's u becomes the correction of x, s and the forces grow. Its b.x and gaps are set.
void PlannedCycles::correct() {
  LevelSolver::Vectors& v = coarse_.first();
  const Edges edges(second_);
  share_each(team_, s_.size(), [&](std::uint32_t i) {
    v.b[i].s = edges.sum_all(i, [&](std::uint32_t other) { return s_[other]; }) - second_.degree[i] * s_[i];
  });
  for (std::size_t a = 0; a < forces_.size(); ++a) {
    v.b[second_.anchors[a]].s += forces_[a];
    v.gaps[a] += forces_[a];
  }
  solve_second();
}

/// Likewise, its b.s being set as well and its gaps those that the forces leave.
void PlannedCycles::solve_second() {
  const LevelSolver::Vectors& v = coarse_.first();
  coarse_.solve();
  share_each(team_, s_.size(), [&](std::uint32_t i) { s_[i] += v.u[i].s; });
  for (std::size_t a = 0; a < forces_.size(); ++a) forces_[a] += v.forces[a];
}

/// x is the second level's solution.
void PlannedCycles::start(const DeltaView& deltas, std::span<const Vec3> targets, RangeWatch* watch) {
  watch_ = watch;
  x_.assign(finest_.node_count(), Counts{});
  std::fill(s_.begin(), s_.end(), Float4{});
  std::fill(forces_.begin(), forces_.end(), Float4{});
  const DeltaCounts parts(deltas, 8);  // exact, if deltas are symbols
  const auto delta = [&](std::uint32_t i) {
    return deltas.has_symbols() ? 0x1p-8F * to_floats(reinterpret_cast<FourInts>(parts[i]))
                                : to_float4(deltas[i]);
  };
  LevelSolver::Vectors& v = coarse_.first();
  std::fill(v.b.begin(), v.b.end(), Row{});
  for (std::uint32_t i = 0; i < finest_.node_count(); ++i) {
    finest_.interpolation[i].spread(unit_degree(finest_, i) * delta(i),
                                    [&](std::uint32_t node) -> Float4& { return v.b[node].x; });
  }
  for (std::size_t a = 0; a < targets.size(); ++a) v.gaps[a] = in_steps(targets[a], deltas);
  solve_second();  // s and the forces are 0 before
  units_ = Units(deltas, largest_coordinate(v.u));
  add_correction();
}

template <bool kIsWatched>
void PlannedCycles::sweep_finest(const DeltaView& deltas, std::span<const float> relaxation) {
  const DeltaCounts counts(deltas, units_.bits());
  // D (delta - L x) in units, of whole numbers as far as these go.
  const auto charge = [&](std::uint32_t i, const auto& row) {
    if (row.is_long()) {
      const auto delta = reinterpret_cast<FourInts>(counts[i]);
      const double degree = row.degree();
      const Double4 sum = row.sum_of_differences(x_.data(), x_[i]);
      return narrow({sum.xy + degree * TwoDoubles{1.0 * delta[0], 1.0 * delta[1]},
                     sum.zw + degree * TwoDoubles{1.0 * delta[2], 1.0 * delta[3]}});
    }
    if constexpr (kIsWatched) {
      const Float4 around = row.sum_floats([&](std::uint32_t other) { return Units::floats(x_[other]); });
      const Float4 delta = units_.per_step() * in_steps(deltas[i], deltas);
      watch_->see(around + row.degree() * (delta - Units::floats(x_[i])));
    }
    return Units::floats(row.sum(x_.data()) + row.times(counts[i] - x_[i]));
  };
  const auto residual = [&](std::uint32_t i, const auto& row) {
    const float degree = row.degree();
    return charge(i, row) - units_.per_step() * degree * degree * finest_.interpolation[i].of(s_);
  };
  sweep(UnitEdges(finest_), relaxation, residual, step_, [&](std::uint32_t i, Float4 step) {
    if constexpr (kIsWatched) watch_->see(Units::floats(x_[i]) + step);
    x_[i] += Units::nearest(step);
  });
}

void PlannedCycles::sweep_finest(const DeltaView& deltas, std::span<const float> relaxation) {
  watch_ != nullptr ? sweep_finest<true>(deltas, relaxation) : sweep_finest<false>(deltas, relaxation);
}

/// x grows by what the second level found.
void PlannedCycles::add_correction() {
  const PositionsOf u{coarse_.first().u};
  if (watch_ != nullptr) {
    for (std::uint32_t i = 0; i < x_.size(); ++i)
      watch_->see(Units::floats(x_[i]) + units_.per_step() * finest_.interpolation[i].of(u));
  }
  share_each(team_, x_.size(),
             [&](std::uint32_t i) { x_[i] += units_.count(finest_.interpolation[i].of(u)); });
}

void PlannedCycles::cycle(const DeltaView& deltas, std::span<const Vec3> targets) {
  sweep_finest(deltas, kSweeps);
  LevelSolver::Vectors& v = coarse_.first();
  std::fill(v.b.begin(), v.b.end(), Row{});
  take_residuals(UnitEdges(finest_), step_, [&](std::uint32_t i, Float4 residual) {
    finest_.interpolation[i].spread(units_.steps(residual),
                                    [&](std::uint32_t node) -> Float4& { return v.b[node].x; });
  });
  for (std::size_t a = 0; a < targets.size(); ++a)
    v.gaps[a] = in_steps(targets[a] - units_.position(x_[finest_.anchors[a]]), deltas);
  correct();
  add_correction();
}

PlannedSolution PlannedCycles::solve(const DeltaView& deltas, std::span<const Vec3> targets, int cycles,
                                     RangeWatch* watch) {
  start(deltas, targets, watch);
  for (int c = 0; c < cycles; ++c) cycle(deltas, targets);
  return finish(deltas);
}

PlannedSolution PlannedCycles::finish(const DeltaView& deltas) {
  sweep_finest(deltas, kLastSweeps);
  return {units_, std::exchange(x_, {})};
}

PlannedSolution PlannedCycles::solution_so_far(const DeltaView& deltas) {
  LargeVector<Counts> kept = x_;
  PlannedSolution solution = finish(deltas);
  x_ = std::move(kept);
  return solution;
}

void PlannedSolution::write(std::span<Vec3> x, ThreadTeam* team) const {
  share_each(team, x.size(), [&](std::uint32_t i) { x[i] = units.position(counts[i]); });
}

}  // namespace deltamesh::multigrid
