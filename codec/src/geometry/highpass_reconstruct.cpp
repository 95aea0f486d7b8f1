// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/large_vector.h"
#include "base/try.h"
#include "format/tags.h"
#include "geometry/highpass_symbols.h"
#include "laplacian/solve_once.h"
#include "topology/subgraph.h"

namespace deltamesh {
namespace {

Vec3 middle(const Box& box) noexcept {
  return 0.5 * box.min + 0.5 * box.max;  // halves first: that cannot overflow
}

DeltaScale scale_of(const HighpassParameters& parameters) noexcept {
  return {.step = parameters.step,
          .shifts = {0, parameters.shift.one / 256.0, parameters.shift.more / 256.0}};
}

/// Of the solved anchors, relative to the middle of the box: near the origin doubles are densest.
std::vector<Vec3> anchor_targets(const HighpassSymbols& symbols, const SolvedPart& part, const Box& box,
                                 const HighpassParameters& parameters) {
  const AnchorLattice lattice(box, parameters.anchor_bits);
  const Vec3 center = middle(box);
  std::vector<Vec3> targets;
  RowWalk walk(part);
  for (std::size_t i = 0; i < symbols.anchors.size(); ++i) {
    if (walk.row_of(symbols.anchors[i])) targets.push_back(lattice.position_of(symbols.cells[i]) - center);
  }
  return targets;
}

bool fits_float(double value) noexcept {
  return std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max());
}

}  // namespace

AnchorLattice::AnchorLattice(const Box& box, int bits) noexcept
    : origin_(box.min),
      last_cell_((std::uint32_t{1} << bits) - 1),
      side_(box.longest_side() / static_cast<double>(last_cell_)) {}

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

std::vector<std::uint32_t> anchor_rows(std::span<const std::uint32_t> anchors, const SolvedPart& part) {
  std::vector<std::uint32_t> rows;
  RowWalk walk(part);
  for (const std::uint32_t anchor : anchors) {
    if (const auto row = walk.row_of(anchor)) rows.push_back(*row);
  }
  return rows;
}

namespace {

/// Marks of the solved vertices; empty where that is all of them.
std::vector<bool> solved_marks(const SolvedPart& part) {
  return part.is_whole() ? std::vector<bool>() : mark_vertices(part.vertices, part.whole_count);
}

/// Positions of all vertices from the solution of `solved`, which are in front: the others are on the
/// lattice [ANCH-2]. Errors: kInvalidStream [DELT-3].
Result<void> complete_positions(const HighpassSymbols& symbols, std::size_t solved,
                                const std::vector<bool>& is_solved, const Box& box,
                                const HighpassParameters& parameters, std::span<Vec3> positions) {
  const Vec3 center = middle(box);
  for (Vec3& x : positions.first(solved)) x = center + x;
  if (!is_solved.empty()) {
    spread_to_marks(positions, is_solved);
    const AnchorLattice lattice(box, parameters.anchor_bits);
    for (std::size_t i = 0; i < symbols.anchors.size(); ++i) {
      const std::uint32_t anchor = symbols.anchors[i];
      if (!is_solved[anchor]) positions[anchor] = lattice.position_of(symbols.cells[i]);
    }
  }
  for (const Vec3& position : positions) {
    if (!(fits_float(position[0]) && fits_float(position[1]) && fits_float(position[2])))
      return Error{.code = ErrorCode::kInvalidStream,
                   .message = "a decoded position is not finite",
                   .rule = "DELT-3",
                   .chunk_tag = kTagDeltas};
  }
  return {};
}

}  // namespace

Result<LargeVector<Vec3>> reconstruct_highpass(const HighpassSymbols& symbols, const SolvedPart& part,
                                               PartSolver& solver, const Box& box,
                                               const HighpassParameters& parameters) {
  LargeVector<Vec3> positions(part.whole_count);
  if (part.row_count > 0) {
    DELTAMESH_CHECK(solver.solve(anchor_rows(symbols.anchors, part),
                                 DeltaView(symbols.deltas, scale_of(parameters)),
                                 anchor_targets(symbols, part, box, parameters), parameters.half_cycles,
                                 std::span(positions).first(part.row_count)));
  }
  DELTAMESH_CHECK(
      complete_positions(symbols, part.row_count, solved_marks(part), box, parameters, positions));
  return positions;
}

Result<LargeVector<Vec3>> reconstruct_highpass_once(HighpassSymbols symbols, SolvedPart part, const Box& box,
                                                    const HighpassParameters& parameters) {
  const std::vector<bool> is_solved = solved_marks(part);
  LargeVector<Vec3> positions;
  if (part.row_count > 0) {
    LeastSquaresProblem problem{.graph = std::exchange(part.graph, {}),
                                .components = std::exchange(part.components, {}),
                                .anchors = anchor_rows(symbols.anchors, part),
                                .symbols = std::exchange(symbols.deltas, {}),
                                .scale = scale_of(parameters),
                                .targets = anchor_targets(symbols, part, box, parameters),
                                .half_cycles = parameters.half_cycles};
    std::vector<std::uint32_t>().swap(part.vertices);
    DELTAMESH_TRY(positions, solve_once(std::move(problem), part.whole_count));
  }
  positions.resize(part.whole_count);  // where there was nothing to solve
  DELTAMESH_CHECK(complete_positions(symbols, part.row_count, is_solved, box, parameters, positions));
  return positions;
}

}  // namespace deltamesh
