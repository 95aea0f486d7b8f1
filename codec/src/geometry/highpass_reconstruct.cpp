// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/try.h"
#include "format/tags.h"
#include "geometry/delta_quantizer.h"
#include "geometry/highpass_symbols.h"

namespace deltamesh {
namespace {

Result<void> solve_part(const HighpassSymbols& symbols, const SolvedPart& part, PartSolver& solver,
                        const Vec3& center, const DeltaQuantizer& quantizer, std::vector<Vec3>& positions) {
  const std::size_t count = part.vertices.size();
  std::vector<std::uint32_t> anchor_rows;
  std::vector<Vec3> anchor_positions;
  for (const std::uint32_t anchor : symbols.anchors) {
    if (part.rows[anchor] == SolvedPart::kNoRow) continue;
    anchor_rows.push_back(part.rows[anchor]);
    anchor_positions.push_back(positions[anchor] - center);
  }
  std::vector<Vec3> deltas(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      deltas[i][axis] = quantizer.value(symbols.deltas[axis * count + i]);
  }
  std::vector<Vec3> solution(count);
  DELTAMESH_CHECK(solver.solve(anchor_rows, deltas, anchor_positions, solution));
  for (std::size_t i = 0; i < count; ++i) positions[part.vertices[i]] = center + solution[i];
  return {};
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

Result<std::vector<Vec3>> reconstruct_highpass(const HighpassSymbols& symbols, const SolvedPart& part,
                                               PartSolver& solver, const Box& box,
                                               const HighpassParameters& parameters) {
  std::vector<Vec3> positions(part.rows.size());
  const AnchorLattice lattice(box, parameters.anchor_bits);
  for (std::size_t i = 0; i < symbols.anchors.size(); ++i)
    positions[symbols.anchors[i]] = lattice.position_of(symbols.cells[i]);
  if (!part.vertices.empty()) {
    // Near the origin doubles are densest; and adding halves first cannot overflow.
    const Vec3 center = 0.5 * box.min + 0.5 * box.max;
    const DeltaQuantizer quantizer{.step = parameters.step, .shift = parameters.shift};
    DELTAMESH_CHECK(solve_part(symbols, part, solver, center, quantizer, positions));
  }
  for (const Vec3& position : positions) {
    if (!(fits_float(position[0]) && fits_float(position[1]) && fits_float(position[2])))
      return Error{.code = ErrorCode::kInvalidStream,
                   .message = "a decoded position is not finite",
                   .rule = "DELT-3",
                   .chunk_tag = kTagDeltas};
  }
  return positions;
}

}  // namespace deltamesh
