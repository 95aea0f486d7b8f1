// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/settled_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/try.h"
#include "laplacian/settling/acceleration.h"
#include "laplacian/settling/cycle.h"
#include "laplacian/settling/hierarchy.h"
#include "laplacian/settling/settling.h"

namespace deltamesh::settling {
namespace {

/// Plain cycles go on while the change falls by this from one to the next.
constexpr int kPlainCycles = 12;
constexpr double kGoodProgress = 0.5;

/// In hard cases, where strips or peninsulas that hang by few edges are wrong on coarse levels, the coarsest
/// level is dropped, at most kMaxDrops times, when the change has not fallen to kPoorProgress in
/// kCyclesPerDrop cycles.
constexpr int kCyclesPerDrop = 2;
constexpr double kPoorProgress = 0.3;
constexpr int kMaxDrops = 2;

/// Accelerated cycles: how many before the small components that still move are factored, and at the most.
constexpr int kPatience = 10;
constexpr int kAcceleratedCycles = 40;

/// Solutions without coarser levels of the large ones, each of the residual of the last.
constexpr int kRounds = 3;

constexpr double kUnknownRate = 0.7;

bool has_mark(std::span<const std::uint8_t> marks) noexcept {
  return std::find(marks.begin(), marks.end(), 1) != marks.end();
}

}  // namespace

/// One group's problem and its solution in the making.
class GroupSolver {
 public:
  explicit GroupSolver(Group group)
      : group_(std::move(group)),
        levels_(build_hierarchy(*group_.graph, group_.anchors, group_.depth)),
        cycles_(levels_, group_.components, group_.depth == 0),
        targets_(group_.anchors.size()),
        settling_(group_) {}
  GroupSolver(const GroupSolver&) = delete;
  GroupSolver& operator=(const GroupSolver&) = delete;

  /// `x`: where to start without levels; overwritten with the solution.
  Result<void> solve(const DeltaView& deltas, std::span<const Vec3> anchor_positions, std::span<Vec3> x) {
    if (group_.vertices.empty()) {
      deltas_ = deltas;
      x_ = x;
    } else {
      gather(deltas, x);
    }
    for (std::size_t a = 0; a < targets_.size(); ++a) targets_[a] = anchor_positions[group_.anchor_of[a]];
    if (group_.depth == 0) {
      DELTAMESH_CHECK(run_without_levels());
    } else if (!run_plain()) {
      DELTAMESH_CHECK(run_accelerated());
    }
    for (std::size_t i = 0; i < group_.vertices.size(); ++i) x[group_.vertices[i]] = x_[i];
    return {};
  }

 private:
  /// Own copies for a group that is not the whole graph.
  void gather(const DeltaView& deltas, std::span<const Vec3> x) {
    own_x_.resize(group_.vertices.size());
    x_ = own_x_;
    for (std::size_t i = 0; i < own_x_.size(); ++i) own_x_[i] = x[group_.vertices[i]];
    if (deltas.has_symbols()) {
      own_symbols_ = SymbolRows(deltas.symbols(), group_.vertices);
      deltas_ = DeltaView(own_symbols_.view(), deltas.scale());
    } else {
      own_deltas_.clear();
      for (const std::uint32_t v : group_.vertices) own_deltas_.push_back(deltas[v]);
      deltas_ = own_deltas_;
    }
  }

  /// Cycles until settled (true), or until they make little progress. The first one goes on from start(), in
  /// floats throughout; further ones are corrections.
  bool run_plain() {
    set_first_right_hand_sides();
    cycles_.start();
    for (std::size_t i = 0; i < x_.size(); ++i) x_[i] = to_vec3(cycles_.solution()[i].x);
    cycles_.cycle();
    replace();
    double change = settling_.worst_change();
    for (int c = 1; c < kPlainCycles; ++c) {
      set_right_hand_sides();
      cycles_.cycle();
      absorb();
      const double previous = std::exchange(change, settling_.worst_change());
      const double rate = previous > 0 ? change / previous : kUnknownRate;
      if (is_settled(rate)) return true;
      if (!(rate <= kGoodProgress)) return false;
    }
    return false;
  }

  /// For a group of depth 0: a factorisation where that stays sparse, else conjugate gradients on the
  /// functional.
  Result<void> run_without_levels() {
    const auto is_finite = [](const Vec3& v) { return std::isfinite(dot(v, v)); };
    if (!std::all_of(x_.begin(), x_.end(), is_finite)) std::fill(x_.begin(), x_.end(), Vec3{});
    set_right_hand_sides();
    cycles_.start();
    absorb();
    for (int round = 0; round < kRounds; ++round) {
      set_right_hand_sides();
      cycles_.cycle();
      absorb();
      if (is_settled(kUnknownRate)) return {};
    }
    settling_.tolerate_large_components(progress());
    if (!has_mark(settling_.unsettled())) return {};
    return Error{.code = ErrorCode::kInvalidStream,
                 .message = "the least-squares solution is out of reach",
                 .rule = "DELT-4"};
  }

  /// Cycles that never raise the functional. Components that do not settle are solved without coarser levels.
  Result<void> run_accelerated() {
    Acceleration acceleration(group_);
    double change = settling_.worst_change();
    int drops = 0;
    for (int c = 0; c < kAcceleratedCycles; ++c) {
      set_right_hand_sides();
      acceleration.restart(cycles_);
      acceleration.cycle(cycles_);
      absorb();
      settling_.take_step(acceleration.proposed());
      if (is_settled(kUnknownRate)) return {};
      if (c % kCyclesPerDrop == kCyclesPerDrop - 1) {
        const double previous = std::exchange(change, settling_.worst_change());
        if (change > kPoorProgress * previous && drops < kMaxDrops && cycles_.drop_coarsest()) ++drops;
      }
      if (cycles_.is_exhausted()) break;
      if (c + 1 >= kPatience && largest_bad_component() <= kLargestRescue) break;
    }
    return solve_bad_components();
  }

  std::uint32_t largest_bad_component() const noexcept {
    std::uint32_t largest = 0;
    for (std::size_t c = 0; c < group_.components.count; ++c) {
      if (settling_.unsettled()[c] != 0) largest = std::max(largest, group_.components.size[c]);
    }
    return largest;
  }

  /// D delta and c, for a solution from nothing.
  void set_first_right_hand_sides() {
    for (std::uint32_t i = 0; i < x_.size(); ++i)
      cycles_.delta(i) = to_float4(static_cast<double>(group_.graph->degree(i)) * deltas_[i]);
    for (std::size_t a = 0; a < targets_.size(); ++a) cycles_.target(a) = to_float4(targets_[a]);
  }

  /// D (delta - L x) and c - x_a, in doubles, for a correction that starts from zero. Forces and s stay.
  void set_right_hand_sides() {
    for (std::uint32_t i = 0; i < x_.size(); ++i) {
      Vec3 sum{};
      for (const std::uint32_t j : group_.graph->of(i)) sum = sum + x_[j];
      const double degree = group_.graph->degree(i);
      const Vec3 charge = degree * (deltas_[i] - x_[i]) + sum;
      cycles_.delta(i) = to_float4(charge);
      cycles_.solution()[i].x = Float4{};
    }
    for (std::size_t a = 0; a < targets_.size(); ++a) {
      const Vec3 gap = targets_[a] - x_[group_.anchors[a]];
      cycles_.target(a) = to_float4(gap);
    }
  }

  /// Adds the correction to x and measures it.
  void absorb() {
    settling_.start_step();
    for (std::uint32_t i = 0; i < x_.size(); ++i) {
      const Vec3 correction = to_vec3(cycles_.solution()[i].x);
      x_[i] = x_[i] + correction;
      settling_.measure(i, correction);
    }
  }

  /// Takes the solution for x and measures how much that changes.
  void replace() {
    settling_.start_step();
    for (std::uint32_t i = 0; i < x_.size(); ++i) {
      const Vec3 solution = to_vec3(cycles_.solution()[i].x);
      settling_.measure(i, solution - x_[i]);
      x_[i] = solution;
    }
  }

  bool is_settled(double rate) { return settling_.is_settled(rate, progress()); }

  Progress progress() noexcept { return {deltas_, targets_, x_, cycles_}; }

  /// Without levels.
  Result<void> solve_bad_components() {
    const auto bad = settling_.unsettled();
    if (!has_mark(bad)) return {};
    return GroupSolver(extract_components(group_, bad)).solve(deltas_, targets_, x_);
  }

  Group group_;
  std::vector<Level> levels_;
  CoupledCycle cycles_;
  DeltaView deltas_;
  std::span<Vec3> x_;
  std::vector<Vec3> own_deltas_;
  SymbolRows own_symbols_;
  std::vector<Vec3> own_x_;
  std::vector<Vec3> targets_;
  Settling settling_;
};

SettledSolver::SettledSolver(const Adjacency& graph, Components components,
                             std::span<const std::uint32_t> anchors)
    : small_(graph, components, anchors) {
  for (Group& group : group_components(graph, std::move(components), anchors))
    groups_.push_back(std::make_unique<GroupSolver>(std::move(group)));
}

SettledSolver::~SettledSolver() = default;

Result<void> SettledSolver::solve(const DeltaView& deltas, std::span<const Vec3> anchor_positions,
                                  std::span<Vec3> x) {
  std::fill(x.begin(), x.end(), Vec3{});
  DELTAMESH_CHECK(small_.solve(deltas, anchor_positions, x));
  for (const auto& group : groups_) DELTAMESH_CHECK(group->solve(deltas, anchor_positions, x));
  return {};
}

}  // namespace deltamesh::settling
