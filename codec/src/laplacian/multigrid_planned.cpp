// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid_planned.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "base/thread_team.h"
#include "laplacian/multigrid_edges.h"
#include "laplacian/multigrid_row.h"
#include "laplacian/multigrid_sweeps.h"
#include "laplacian/multigrid_unit_edges.h"

namespace deltamesh::multigrid {
namespace {

/// Nodes of the third level for each anchor, at the least, where s begins there: it is rough next to an
/// anchor.
constexpr std::size_t kNodesPerAnchor = 12;

/// Over-relaxation of the finest level's sweeps in a cycle that is the only one, in every other, and after
/// the last, as interpolation leaves it rough. Measured: more than 1 at first is for the slow errors, less at
/// the end for the rough ones; what one cycle suits can do with two.
constexpr std::array kOnlyFinestSweeps = {1.2F, 1.0F};
constexpr std::array kFinestSweeps = {1.4F, 1.2F, 1.0F};
constexpr std::array kLastSweeps = {1.0F, 1.0F};

/// Of the second level's at the start and in every cycle.
constexpr std::array kStartSecondSweep = {1.25F};
constexpr std::array kSecondSweeps = {1.4F, 1.2F};

/// What interpolation finds of rows.
struct PositionsOf {
  std::span<const Row> rows;
  Float4 operator[](std::uint32_t node) const noexcept { return rows[node].x; }
};

/// Level from which on there is an s of its own.
std::size_t coupled_level(std::span<const Level> levels) noexcept {
  const bool third_will_do =
      levels.size() > 2 && levels[2].node_count() >= kNodesPerAnchor * levels[2].anchors.size();
  return third_will_do ? 2 : 1;
}

/// Of `deltas`.
Float4 in_steps(const Vec3& v, const DeltaView& deltas) noexcept {
  const double step = deltas.scale().step;
  return to_float4({v[0] / step, v[1] / step, v[2] / step});
}

/// Of all axes, in size; not finite where one is not.
float largest_coordinate(std::span<const Float4> values) noexcept {
  Float4 largest{};
  Float4 nothing{};  // the sum of what is 0 where values are finite, else not a number
  for (const Float4 value : values) {
    const Float4 size = value < 0 ? -value : value;
    largest = size > largest ? size : largest;
    nothing += 0 * value;
  }
  return std::max({largest[0], largest[1], largest[2]}) + (nothing[0] + nothing[1] + nothing[2]);
}

}  // namespace

PlannedCycles::PlannedCycles(std::span<const Level> levels, std::vector<std::uint8_t> holds,
                             std::uint32_t component_count)
    : levels_(levels),
      coupled_(coupled_level(levels)),
      solver_(levels, coupled_, std::move(holds), component_count, false),
      step_(levels[0].node_count() + 1),
      u_(levels[1].node_count()),
      s_second_(levels[1].node_count()),
      s_(levels[coupled_].node_count()),
      forces_(levels[0].anchors.size()),
      gaps_(levels[0].anchors.size()) {
  step_.back() = Float4{};  // what UnitEdges takes for neighbours that do not count
  if (!has_middle()) return;
  b_.resize(levels[1].node_count());
}

template <class Each>
void PlannedCycles::restrict_to_second(const Each& each) {
  const std::span<const Interpolation> interpolation = levels_[0].interpolation;
  if (has_middle()) {
    share_each(b_.size(), [&](std::uint32_t i) { b_[i] = Float4{}; });
    each([&](std::uint32_t i, Float4 residual) {
      interpolation[i].spread(residual, [&](std::uint32_t node) -> Float4& { return b_[node]; });
    });
    return;
  }
  const std::span<Row> b = solver_.vectors(1).b;
  share_each(b.size(), [&](std::uint32_t i) { b[i].x = Float4{}; });
  each([&](std::uint32_t i, Float4 residual) {
    interpolation[i].spread(residual, [&](std::uint32_t node) -> Float4& { return b[node].x; });
  });
}

/// Level c: corrects s_ and forces_, and leaves the correction of x and s in its u. Its b.x and gaps are set.
void PlannedCycles::solve_coupled() {
  const Level& level = levels_[coupled_];
  LevelSolver::Vectors& v = solver_.vectors(coupled_);
  const Edges edges(level);
  share_each(s_.size(),
             [&](std::uint32_t i) { v.b[i].s = edges.add_all(i, s_.data(), -level.degree[i] * s_[i]); });
  for (std::size_t a = 0; a < forces_.size(); ++a) {
    v.b[level.anchors[a]].s += forces_[a];
    v.gaps[a] += forces_[a];
  }
  solver_.solve(coupled_);
  share_each(s_.size(), [&](std::uint32_t i) { s_[i] += v.u[i].s; });
  for (std::size_t a = 0; a < forces_.size(); ++a) forces_[a] += v.forces[a];
}

/// u for b, where there is a level between the finest and c: sweeps, whose steps take the place of the finest
/// level's, and the correction from level c.
void PlannedCycles::correct_middle(std::span<const float> relaxation) {
  const Level& level = levels_[1];
  const std::span<Float4> steps = std::span(step_).first(level.node_count());
  LevelSolver::Vectors& next = solver_.vectors(2);
  const Edges edges(level);
  share_each(u_.size(), [&](std::uint32_t i) { u_[i] = Float4{}; });
  for (const std::uint32_t i : level.chunks.rim) steps[i] = Float4{};  // these come last
  sweep(
      level, edges, relaxation,
      [&](std::uint32_t i, const auto&) { return edges.add_lower(i, steps.data(), b_[i]); },
      [&](std::uint32_t i, const auto&) { return edges.add_all(i, steps.data(), b_[i]); }, steps,
      [&](std::uint32_t i, Float4 step) { u_[i] += step; });
  share_each(next.b.size(), [&](std::uint32_t i) { next.b[i].x = Float4{}; });
  take_residuals(level, edges, relaxation.back(), steps, [&](std::uint32_t i, Float4 residual) {
    level.interpolation[i].spread(residual, [&](std::uint32_t node) -> Float4& { return next.b[node].x; });
  });
  for (std::size_t a = 0; a < gaps_.size(); ++a) next.gaps[a] = gaps_[a] - u_[level.anchors[a]];
  solve_coupled();
  share_each(u_.size(), [&](std::uint32_t i) { u_[i] += level.interpolation[i].of(PositionsOf{next.u}); });
}

/// u for b, where there is a level between the finest and c; else for that level's b. s_second_ follows.
void PlannedCycles::correct_from_second(std::span<const float> relaxation) {
  if (has_middle()) {
    correct_middle(relaxation);
    share_each(s_second_.size(), [&](std::uint32_t i) { s_second_[i] = levels_[1].interpolation[i].of(s_); });
  } else {
    LevelSolver::Vectors& second = solver_.vectors(1);
    second.gaps = gaps_;
    solve_coupled();
    share_each(u_.size(), [&](std::uint32_t i) {
      u_[i] = second.u[i].x;
      s_second_[i] = s_[i];
    });
  }
}

/// The second level's solution.
void PlannedCycles::start(const DeltaView& deltas, std::span<const Vec3> targets) {
  const Level& finest = levels_[0];
  solver_.begin();
  std::fill(s_.begin(), s_.end(), Float4{});
  std::fill(forces_.begin(), forces_.end(), Float4{});
  const UnitEdges edges(finest);
  const DeltaCounts parts(deltas, 8);  // exact, if deltas are symbols
  const auto delta = [&](std::uint32_t i) {
    return deltas.has_symbols() ? 0x1p-8F * to_floats(reinterpret_cast<FourInts>(parts[i]))
                                : to_float4(deltas[i]);
  };
  restrict_to_second([&](const auto& take) {
    finest.chunks.visit([&](std::uint32_t i) { take(i, edges.degree(i) * delta(i)); });
  });
  for (std::size_t a = 0; a < targets.size(); ++a) gaps_[a] = in_steps(targets[a], deltas);
  correct_from_second(kStartSecondSweep);
  units_ = Units(deltas, largest_coordinate(u_));
  share_each(x_.size(), [&](std::uint32_t i) { x_[i] = units_.count(finest.interpolation[i].of(u_)); });
}

/// `s_at(interpolation)`: s of the vertex with this row of P.
template <class S>
void PlannedCycles::sweep_finest(const DeltaView& deltas, std::span<const float> relaxation, const S& s_at) {
  const Level& finest = levels_[0];
  const UnitEdges edges(finest);
  const DeltaCounts counts(deltas, units_.bits());
  // D (delta - L x) - D^2 s in units, of whole numbers as far as these go.
  const auto residual = [&](std::uint32_t i, const auto& row) {
    const Counts charge = row.sum(x_.data()) + row.times(counts[i] - x_[i]);
    const float degree = row.degree();
    return Units::floats(charge) - units_.per_step() * degree * degree * s_at(finest.interpolation[i]);
  };
  const auto keep = [&](std::uint32_t i, Float4 step) { x_[i] += Units::nearest(step); };
  sweep(finest, edges, relaxation, residual, residual, step_, keep);
}

/// With s as interpolated.
void PlannedCycles::sweep_finest(const DeltaView& deltas, std::span<const float> relaxation) {
  sweep_finest(deltas, relaxation, [&](const Interpolation& p) { return p.of(s_second_); });
}

void PlannedCycles::cycle(const DeltaView& deltas, std::span<const Vec3> targets,
                          std::span<const float> relaxation, bool is_first) {
  const Level& finest = levels_[0];
  if (is_first) {
    sweep_finest(deltas, relaxation, [&](const Interpolation& p) { return p.favorite(s_second_); });
  } else {
    sweep_finest(deltas, relaxation);
  }
  restrict_to_second([&](const auto& take) {
    take_residuals(finest, UnitEdges(finest), relaxation.back(), step_,
                   [&](std::uint32_t i, Float4 residual) { take(i, units_.steps(residual)); });
  });
  for (std::size_t a = 0; a < targets.size(); ++a) {
    gaps_[a] = in_steps(targets[a] - units_.position(x_[finest.anchors[a]]), deltas);
  }
  correct_from_second(kSecondSweeps);
  share_each(x_.size(), [&](std::uint32_t i) { x_[i] += units_.count(finest.interpolation[i].of(u_)); });
}

PlannedSolution PlannedCycles::solve(const DeltaView& deltas, std::span<const Vec3> targets, int cycles) {
  x_.resize(levels_[0].node_count());
  start(deltas, targets);
  const auto relaxation = cycles == 1 ? std::span<const float>(kOnlyFinestSweeps) : kFinestSweeps;
  for (int c = 0; c < cycles; ++c) cycle(deltas, targets, relaxation, c == 0);
  sweep_finest(deltas, kLastSweeps);
  return {units_, std::exchange(x_, {})};
}

void PlannedSolution::write(std::span<Vec3> x) const {
  share_each(x.size(), [&](std::uint32_t i) { x[i] = units.position(counts[i]); });
}

}  // namespace deltamesh::multigrid
