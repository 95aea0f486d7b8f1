// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Cycles in floats, as many as planned, or around a solution in doubles with a watch on every component and a
// factorisation for those that do not settle.
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "base/try.h"
#include "laplacian/multigrid_acceleration.h"
#include "laplacian/multigrid_cycle.h"
#include "laplacian/multigrid_factored_group.h"
#include "laplacian/multigrid_groups.h"
#include "laplacian/multigrid_hierarchy.h"
#include "laplacian/multigrid_planned.h"
#include "laplacian/multigrid_settling.h"
#include "laplacian/small_components.h"
#include "laplacian/solver.h"

namespace deltamesh {
namespace {

using multigrid::FactoredGroup;
using multigrid::Float4;
using multigrid::Group;
using multigrid::kLargestRescue;
using multigrid::MultigridCycle;
using multigrid::PlannedCycles;
using multigrid::PlannedSolution;
using multigrid::to_float4;
using multigrid::to_vec3;

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

/// One group's problem and its solution in the making.
class GroupSolver {
 public:
  explicit GroupSolver(Group group)
      : group_(std::move(group)), targets_(group_.anchors.size()), settling_(group_) {}
  GroupSolver(const GroupSolver&) = delete;
  GroupSolver& operator=(const GroupSolver&) = delete;

  /// What solve() with so many cycles would set up first.
  void set_up(int cycles) {
    if (cycles > 0 && group_.depth > 0 && quick_levels_.empty()) plan();
    if (is_planned(cycles)) return;
    if (group_.components.label.empty()) group_.components = find_components(*group_.graph);
    if (cycles_) return;
    levels_ = make_levels(multigrid::Coarsening::kExact);
    cycles_ = std::make_unique<MultigridCycle>(levels_, group_.components, group_.depth == 0);
  }

  /// Whether it is that of all vertices of the graph.
  bool is_whole() const noexcept { return group_.vertices.empty(); }

  /// For a group that is whole and planned; the last solution.
  PlannedSolution solve_planned(const DeltaView& deltas, std::span<const Vec3> anchor_positions, int cycles) {
    set_targets(anchor_positions);
    return planned_->solve(deltas, targets_, cycles);
  }

  /// `x`: where to start without levels; overwritten with the solution. `cycles`: 0 for as many as it
  /// takes.
  Result<void> solve(const DeltaView& deltas, std::span<const Vec3> anchor_positions, int cycles,
                     std::span<Vec3> x) {
    set_up(cycles);
    if (is_whole()) {
      deltas_ = deltas;
      x_ = x;
    } else {
      gather(deltas, x, is_planned(cycles));
    }
    set_targets(anchor_positions);
    if (is_planned(cycles)) {
      planned_->solve(deltas_, targets_, cycles).write(x_);
    } else if (group_.depth == 0) {
      DELTAMESH_CHECK(run_without_levels());
    } else if (!run_plain()) {
      DELTAMESH_CHECK(run_accelerated());
    }
    for (std::size_t i = 0; i < group_.vertices.size(); ++i) x[group_.vertices[i]] = x_[i];
    return {};
  }

  /// Without coarser levels there is nothing to plan. After set_up().
  bool is_planned(int cycles) const noexcept { return cycles > 0 && planned_; }

 private:
  /// Planned cycles do not ask for components, whose labels would take up memory beside the levels.
  void plan() {
    std::vector<std::uint8_t> holds = multigrid::shared_components(group_.components, group_.anchors);
    group_.components.label = LargeVector<std::uint32_t>();
    quick_levels_ = make_levels(multigrid::Coarsening::kQuick);
    if (quick_levels_.size() > 1)
      planned_ = std::make_unique<PlannedCycles>(quick_levels_, std::move(holds), group_.components.count);
  }

  void set_targets(std::span<const Vec3> anchor_positions) {
    for (std::size_t a = 0; a < targets_.size(); ++a) targets_[a] = anchor_positions[group_.anchor_of[a]];
  }

  std::vector<multigrid::Level> make_levels(multigrid::Coarsening how) const {
    return multigrid::build_hierarchy(*group_.graph, group_.anchors, group_.depth, how);
  }

  /// Own copies for a group that is not the whole graph.
  void gather(const DeltaView& deltas, std::span<const Vec3> x, bool is_planned) {
    own_x_.resize(group_.vertices.size());
    x_ = own_x_;
    if (!is_planned) {
      for (std::size_t i = 0; i < own_x_.size(); ++i) own_x_[i] = x[group_.vertices[i]];
    }
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
    cycles_->start();
    for (std::size_t i = 0; i < x_.size(); ++i) x_[i] = to_vec3(cycles_->solution()[i].x);
    cycles_->cycle();
    replace();
    double change = settling_.worst_change();
    for (int c = 1; c < kPlainCycles; ++c) {
      set_right_hand_sides();
      cycles_->cycle();
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
    cycles_->start();
    absorb();
    for (int round = 0; round < kRounds; ++round) {
      set_right_hand_sides();
      cycles_->cycle();
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
    multigrid::Acceleration acceleration(group_);
    double change = settling_.worst_change();
    int drops = 0;
    for (int c = 0; c < kAcceleratedCycles; ++c) {
      set_right_hand_sides();
      acceleration.restart(*cycles_);
      acceleration.cycle(*cycles_);
      absorb();
      settling_.take_step(acceleration.proposed());
      if (is_settled(kUnknownRate)) return {};
      if (c % kCyclesPerDrop == kCyclesPerDrop - 1) {
        const double previous = std::exchange(change, settling_.worst_change());
        if (change > kPoorProgress * previous && drops < kMaxDrops && cycles_->drop_coarsest()) ++drops;
      }
      if (cycles_->is_exhausted()) break;
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
      cycles_->delta(i) = to_float4(static_cast<double>(group_.graph->degree(i)) * deltas_[i]);
    for (std::size_t a = 0; a < targets_.size(); ++a) cycles_->target(a) = to_float4(targets_[a]);
  }

  /// D (delta - L x) and c - x_a, in doubles, for a correction that starts from zero. Forces and s stay.
  void set_right_hand_sides() {
    for (std::uint32_t i = 0; i < x_.size(); ++i) {
      Vec3 sum{};
      for (const std::uint32_t j : group_.graph->of(i)) sum = sum + x_[j];
      const double degree = group_.graph->degree(i);
      const Vec3 charge = degree * (deltas_[i] - x_[i]) + sum;
      cycles_->delta(i) = to_float4(charge);
      cycles_->solution()[i].x = Float4{};
    }
    for (std::size_t a = 0; a < targets_.size(); ++a) {
      const Vec3 gap = targets_[a] - x_[group_.anchors[a]];
      cycles_->target(a) = to_float4(gap);
    }
  }

  /// Adds the correction to x and measures it.
  void absorb() {
    settling_.start_step();
    for (std::uint32_t i = 0; i < x_.size(); ++i) {
      const Vec3 correction = to_vec3(cycles_->solution()[i].x);
      x_[i] = x_[i] + correction;
      settling_.measure(i, correction);
    }
  }

  /// Takes the solution for x and measures how much that changes.
  void replace() {
    settling_.start_step();
    for (std::uint32_t i = 0; i < x_.size(); ++i) {
      const Vec3 solution = to_vec3(cycles_->solution()[i].x);
      settling_.measure(i, solution - x_[i]);
      x_[i] = solution;
    }
  }

  bool is_settled(double rate) { return settling_.is_settled(rate, progress()); }

  multigrid::Progress progress() noexcept { return {deltas_, targets_, x_, *cycles_}; }

  /// Factors the bad components if they are small; goes on without levels with the large ones.
  Result<void> solve_bad_components() {
    const auto bad = settling_.unsettled();
    std::vector<std::uint8_t> small(bad.size(), 0), large(bad.size(), 0);
    for (std::size_t c = 0; c < bad.size(); ++c)
      (group_.components.size[c] <= kLargestRescue ? small : large)[c] = bad[c];
    if (has_mark(small)) {
      DELTAMESH_TRY(const auto solver, FactoredGroup::make(extract_components(group_, small)));
      DELTAMESH_CHECK(solver->solve(deltas_, targets_, x_));
    }
    if (!has_mark(large)) return {};
    return GroupSolver(extract_components(group_, large)).solve(deltas_, targets_, 0, x_);
  }

  Group group_;  ///< without labels of components once cycles are planned
  std::vector<multigrid::Level> levels_;
  std::unique_ptr<MultigridCycle> cycles_;  ///< for as many as it takes
  std::vector<multigrid::Level> quick_levels_;
  std::unique_ptr<PlannedCycles> planned_;  ///< for a given number
  DeltaView deltas_;
  std::span<Vec3> x_;
  std::vector<Vec3> own_deltas_;
  SymbolRows own_symbols_;
  std::vector<Vec3> own_x_;
  std::vector<Vec3> targets_;
  multigrid::Settling settling_;
};

class MultigridSolver final : public LeastSquaresSolver {
 public:
  explicit MultigridSolver(SmallComponents small) : small_(std::move(small)) {}

  void add(Group group) { groups_.push_back(std::make_unique<GroupSolver>(std::move(group))); }

  void set_up(int cycles) override {
    for (const auto& group : groups_) group->set_up(cycles);
  }

  Result<void> solve(const DeltaView& deltas, std::span<const Vec3> anchor_positions, int cycles,
                     std::span<Vec3> x) override {
    set_up(cycles);
    const auto is_planned = [&](const auto& group) { return group->is_planned(cycles); };
    if (!std::all_of(groups_.begin(), groups_.end(), is_planned)) std::fill(x.begin(), x.end(), Vec3{});
    DELTAMESH_CHECK(small_.solve(deltas, anchor_positions, x));
    for (const auto& group : groups_) DELTAMESH_CHECK(group->solve(deltas, anchor_positions, cycles, x));
    return {};
  }

  Result<LargeVector<Vec3>> solve_last(const DeltaView& deltas, std::span<const Vec3> anchor_positions,
                                       int cycles, std::size_t size) override {
    set_up(cycles);
    if (groups_.size() != 1 || !groups_.front()->is_whole() || !groups_.front()->is_planned(cycles))
      return LeastSquaresSolver::solve_last(deltas, anchor_positions, cycles, size);
    const PlannedSolution solution = groups_.front()->solve_planned(deltas, anchor_positions, cycles);
    groups_.clear();
    LargeVector<Vec3> x(size);
    solution.write(std::span(x).first(deltas.size()));
    return x;
  }

 private:
  SmallComponents small_;
  std::vector<std::unique_ptr<GroupSolver>> groups_;
};

}  // namespace

Result<std::unique_ptr<LeastSquaresSolver>> make_multigrid_solver(const Adjacency& graph,
                                                                  std::span<const std::uint32_t> anchors) {
  return make_solver_for_components(graph, find_components(graph), anchors);
}

Result<std::unique_ptr<LeastSquaresSolver>> make_solver_for_components(
    const Adjacency& graph, Components components, std::span<const std::uint32_t> anchors) {
  auto solver = std::make_unique<MultigridSolver>(SmallComponents(graph, components, anchors));
  for (Group& group : multigrid::group_components(graph, std::move(components), anchors))
    solver->add(std::move(group));
  return std::unique_ptr<LeastSquaresSolver>(std::move(solver));
}

}  // namespace deltamesh
