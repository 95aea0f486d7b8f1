// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The integers of a highpass stream, between bytes and positions. Shared by writer and reader, so that both
// reconstruct the same bits.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/numbers/vec3.h"
#include "deltamesh/result.h"
#include "highpass/highpass.h"
#include "laplacian/operator/solved_part.h"
#include "laplacian/operator/symbol_rows.h"
#include "laplacian/solver.h"
#include "topology/adjacency.h"

namespace deltamesh {

using AnchorCell = std::array<std::uint32_t, 3>;

struct HighpassSymbols {
  SymbolRows deltas;                   ///< of every solved vertex; units of the step
  std::vector<std::uint32_t> anchors;  ///< ascending vertices
  std::vector<AnchorCell> cells{};     ///< position of every anchor on the anchor lattice
};

/// The lattice of anchor positions: cubic cells that divide the longest side of the box [ANCH-4].
class AnchorLattice {
 public:
  AnchorLattice(const Box& box, int bits) noexcept;

  /// The cube that the positions of all cells lie in.
  static Box cube_over(const Box& box) noexcept;

  AnchorCell cell_of(const Vec3& position) const noexcept;
  Vec3 position_of(const AnchorCell& cell) const noexcept;

 private:
  Vec3 origin_;
  std::uint32_t last_cell_;
  double side_;
};

/// Centre of the box. The solver's coordinates are relative to it, as doubles are densest near 0.
Vec3 middle(const Box& box) noexcept;

/// Rows of the anchors of the solved part, ascending.
std::vector<std::uint32_t> anchor_rows(std::span<const std::uint32_t> anchors, const SolvedPart& part);

/// Solves for the vertices of `part` with `solver`, whose graph is the part's, and takes the others from the
/// anchor lattice. `symbols` are checked against [DELT-*] and [ANCH-*] already, apart from floats. Returns
/// one position per vertex of the whole graph. Errors: kInvalidStream [DELT-3] where a position is not finite
/// as float32.
Result<LargeVector<Vec3>> reconstruct_highpass(const HighpassSymbols& symbols, const SolvedPart& part,
                                               PlannedSolver& solver, const Box& box,
                                               const HighpassParameters& parameters);

/// Calls look(cycles, errors) for 1, 2, 3... cycles, until it returns false: what rounding alone adds to the
/// positions of `part`, whatever the cycles leave out. `positions`: n, before coding; `deltas`: theirs, over
/// the rows of `part`; `parameters`: whose cycles do not matter. Errors: as PlannedSolver::solve().
Result<void> follow_rounding(std::span<const Vec3> positions, std::span<const Vec3> deltas,
                             const HighpassSymbols& symbols, const SolvedPart& part, PlannedSolver& solver,
                             const Box& box, const HighpassParameters& parameters,
                             const PlannedSolver::Look& look);

/// Returns the deltas' symbols; called once, with the graph of the solved part.
using ReadSymbols = std::function<Result<SymbolRows>(const Adjacency&)>;

/// The same positions to the last bit, for decoders. Without a `team` (null) it takes the least memory; with
/// one, a thread reads the symbols of the deltas while the others set up the solver. Errors: those of
/// reconstruct_highpass() and of `read_deltas`.
Result<LargeVector<Vec3>> reconstruct_highpass_once(const ReadSymbols& read_deltas,
                                                    const HighpassSymbols& anchors, SolvedPart part,
                                                    const Box& box, const HighpassParameters& parameters,
                                                    ThreadTeam* team);

}  // namespace deltamesh
