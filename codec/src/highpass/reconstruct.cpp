// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/broken_rule.h"
#include "base/memory/large_vector.h"
#include "base/threads/task.h"
#include "base/try.h"
#include "format/chunk/tags.h"
#include "highpass/delta_quantizer.h"
#include "highpass/symbols.h"
#include "laplacian/solver.h"
#include "topology/vertex_subset.h"

namespace deltamesh {
namespace {

/// Of the solved anchors, relative to the middle of the box.
std::vector<Vec3> anchor_targets(const HighpassSymbols& symbols, const SolvedPart& part, const Box& box,
                                 const HighpassParameters& parameters) {
  const AnchorLattice lattice(box, parameters.anchor_bits);
  const Vec3 center = middle(box);
  std::vector<Vec3> targets;
  SubsetCursor cursor(part.vertices);
  for (std::size_t i = 0; i < symbols.anchors.size(); ++i) {
    if (cursor.row_of(symbols.anchors[i])) targets.push_back(lattice.position_of(symbols.cells[i]) - center);
  }
  return targets;
}

bool fits_float(const Vec3& position) noexcept {
  constexpr auto kLargest = static_cast<double>(std::numeric_limits<float>::max());
  bool fits = true;
  for (const double x : position) fits &= std::abs(x) <= kLargest;
  return fits;
}

/// Positions of all vertices from the solution, whose rows are in front: the vertices that are not among
/// `solved` are on the lattice [ANCH-2]. Errors: kInvalidStream [DELT-3].
Result<void> complete_positions(const HighpassSymbols& symbols, const VertexSubset& solved, const Box& box,
                                const HighpassParameters& parameters, std::span<Vec3> positions) {
  const Vec3 center = middle(box);
  bool fits = true;
  for (Vec3& x : positions.first(solved.size())) {
    x = center + x;
    fits &= fits_float(x);
  }
  spread_rows(solved, positions);
  const AnchorLattice lattice(box, parameters.anchor_bits);
  SubsetCursor cursor(solved);
  for (std::size_t i = 0; i < symbols.anchors.size(); ++i) {
    const std::uint32_t anchor = symbols.anchors[i];
    if (cursor.row_of(anchor)) continue;
    positions[anchor] = lattice.position_of(symbols.cells[i]);
    if (!fits_float(positions[anchor])) fits = false;
  }
  if (fits) return {};
  return broken_rule("a decoded position is not finite", "DELT-3", kTagDeltas);
}

}  // namespace

AnchorLattice::AnchorLattice(const Box& box, int bits) noexcept
    : origin_(box.min),
      last_cell_((std::uint32_t{1} << bits) - 1),
      side_(box.longest_side() / static_cast<double>(last_cell_)) {}

Box AnchorLattice::cube_over(const Box& box) noexcept {
  const double side = box.longest_side();
  return {box.min, box.min + Vec3{side, side, side}};
}

AnchorCell AnchorLattice::cell_of(const Vec3& position) const noexcept {
  AnchorCell cell{};
  if (!(side_ > 0)) return cell;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double rounded = std::round((position[axis] - origin_[axis]) / side_);
    cell[axis] = static_cast<std::uint32_t>(std::clamp(rounded, 0.0, static_cast<double>(last_cell_)));
  }
  return cell;
}

Vec3 AnchorLattice::position_of(const AnchorCell& cell) const noexcept {
  Vec3 position{};
  for (std::size_t axis = 0; axis < 3; ++axis) position[axis] = origin_[axis] + side_ * cell[axis];
  return position;
}

Vec3 middle(const Box& box) noexcept {
  return 0.5 * box.min + 0.5 * box.max;  // halves first: that cannot overflow
}

std::vector<std::uint32_t> anchor_rows(std::span<const std::uint32_t> anchors, const SolvedPart& part) {
  std::vector<std::uint32_t> rows;
  SubsetCursor cursor(part.vertices);
  for (const std::uint32_t anchor : anchors) {
    if (const auto row = cursor.row_of(anchor)) rows.push_back(*row);
  }
  return rows;
}

Result<LargeVector<Vec3>> reconstruct_highpass(const HighpassSymbols& symbols, const SolvedPart& part,
                                               PlannedSolver& solver, const Box& box,
                                               const HighpassParameters& parameters) {
  LargeVector<Vec3> positions(part.whole_count);
  if (part.row_count > 0) {
    DELTAMESH_CHECK(
        solver.solve(anchor_rows(symbols.anchors, part),
                     DeltaView(symbols.deltas.view(), scale_of(parameters.step, parameters.shift)),
                     anchor_targets(symbols, part, box, parameters), parameters.cycles,
                     std::span(positions).first(part.row_count)));
  }
  DELTAMESH_CHECK(complete_positions(symbols, part.vertices, box, parameters, positions));
  return positions;
}

Result<void> follow_rounding(std::span<const Vec3> positions, std::span<const Vec3> deltas,
                             const HighpassSymbols& symbols, const SolvedPart& part, PlannedSolver& solver,
                             const Box& box, const HighpassParameters& parameters,
                             const PlannedSolver::Look& look) {
  // The problem is that of the errors, in steps: these are small, so that nothing is lost.
  const double per_step = 1 / parameters.step;
  const DeltaView rounded(symbols.deltas.view(), scale_of(parameters.step, parameters.shift));
  std::vector<Vec3> errors(part.row_count);
  for (std::size_t row = 0; row < errors.size(); ++row) errors[row] = per_step * (rounded[row] - deltas[row]);
  const std::vector<std::uint32_t> anchors = anchor_rows(symbols.anchors, part);
  std::vector<Vec3> targets = anchor_targets(symbols, part, box, parameters);
  for (std::size_t a = 0; a < anchors.size(); ++a)
    targets[a] = per_step * (targets[a] - (positions[part.vertex(anchors[a])] - middle(box)));
  std::vector<Vec3> found(part.row_count);
  return solver.follow(anchors, errors, targets, [&](int cycles, std::span<const Vec3> x) {
    for (std::size_t row = 0; row < x.size(); ++row) found[row] = parameters.step * x[row];
    return look(cycles, found);
  });
}

Result<LargeVector<Vec3>> reconstruct_highpass_once(const ReadSymbols& read_deltas,
                                                    const HighpassSymbols& anchors, SolvedPart part,
                                                    const Box& box, const HighpassParameters& parameters,
                                                    ThreadTeam* team) {
  LargeVector<Vec3> positions;
  if (part.row_count > 0) {
    const Adjacency graph = std::exchange(part.graph, {});
    Task reading(team, [&] { return read_deltas(graph); });
    const Components components = std::exchange(part.components, {});
    const std::vector<std::uint32_t> rows = anchor_rows(anchors.anchors, part);
    SingleSolve solve({graph, components, team}, rows);
    DELTAMESH_TRY(const SymbolRows deltas, reading.get());
    DELTAMESH_TRY(positions,
                  std::move(solve).solve(
                      DeltaView(deltas.view(), scale_of(parameters.step, parameters.shift)),
                      anchor_targets(anchors, part, box, parameters), parameters.cycles, part.whole_count));
  } else {
    DELTAMESH_TRY([[maybe_unused]] const auto none, read_deltas(part.graph));
    positions.resize(part.whole_count);
  }
  DELTAMESH_CHECK(complete_positions(anchors, part.vertices, box, parameters, positions));
  return positions;
}

}  // namespace deltamesh
