// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The predictive coder as a search sees it: candidates from lattices, voxels, and exact floats.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "grid/source/fit.h"
#include "positions/lattice/axis_values.h"
#include "positions/lattice/replacements.h"
#include "positions/positions.h"
#include "search/candidate.h"
#include "search/request.h"

namespace deltamesh {

/// Positions on a lattice, before they are coded.
struct LatticeTrial {
  PredictiveParameters parameters;
  std::vector<Cell> cells;
  Quality quality{};                        ///< with VDE only where that is bounded
  std::vector<Replacement> replacements{};  ///< of an exact lattice
};

class PredictiveTrials {
 public:
  /// The arguments must outlive the trials. At effort 0 grids are looked for in a sample.
  PredictiveTrials(const Request& request, const SourceGeometry& source, const StreamRest& rest);

  LatticeTrial try_lattice(const PositionLattice& lattice, const Bounds& bounds = {}) const;
  /// On voxels with so many levels along an edge; empty where they have no room for so many.
  std::optional<LatticeTrial> try_levels(const VoxelFit& fit, std::uint32_t levels,
                                         const Bounds& bounds = {}) const;

  /// In a given form; without one, in the smallest of those that the effort allows. There is
  /// one plain form only.
  Candidate code(const LatticeTrial& trial, const std::optional<PositionForm>& form = std::nullopt) const;
  /// Of try_levels(): faces and positions at once; empty where the grid coder is no use (write_grid()).
  std::optional<Candidate> code_in_cubes(const LatticeTrial& trial) const;
  /// The cubic lattice of this step, model units, above 0. Errors: kInvalidArgument where that takes more
  /// than kMostCells.
  Result<Candidate> code_step(double step) const;
  /// Every position to the last bit; in a given form, or the smallest.
  Candidate code_exactly(const std::optional<PositionForm>& form = std::nullopt) const;

  /// Whose points, as floats, are the source's positions, but for few; empty where there is
  /// none, and in the plain form.
  std::optional<PositionLattice> exact_lattice() const;

  /// The step of 2^bits points along the longest side.
  double step_for_bits(int bits) const noexcept;
  /// The axes whose coordinates all are on a grid, of steps of at least `finest`.
  std::array<AxisGrid, 3> axes(double finest) const { return fit_axes(values_, source_.box, finest); }
  /// The voxels that the mesh was cut from: those of the request's grid, or looked for when first
  /// asked for. None in the plain form, which gains nothing by them.
  const std::optional<VoxelFit>& voxels() const;

  /// Levels of the voxels that starting states are of; 0 without.
  std::uint32_t usual_levels() const noexcept;

  const SourceGeometry& source() const noexcept { return source_; }
  const Request& request() const noexcept { return request_; }

 private:
  LatticeTrial measured(PredictiveParameters parameters, std::vector<Cell> cells, const Bounds& bounds) const;
  /// The payload in a given form.
  using WritePositions = std::function<std::vector<std::byte>(const PositionForm&)>;
  Candidate finished(Candidate candidate, std::vector<std::byte> payload) const;
  Candidate in_form(const PositionForm& form, Candidate candidate, const WritePositions& write) const;
  Candidate in_smallest_form(Candidate candidate, const WritePositions& write) const;
  /// All but the chunk.
  Candidate shell(const LatticeTrial& trial) const;
  WritePositions writer(const LatticeTrial& trial) const;
  Candidate code_floats(const std::optional<PositionForm>& form) const;
  bool is_plain() const noexcept { return request_.profile == Profile::kZstd; }
  FaceList faces() const noexcept {
    return {source_.triangles, static_cast<std::uint32_t>(source_.positions.size())};
  }

  const Request& request_;
  const SourceGeometry& source_;
  StreamRest rest_;
  AxisValues values_;
  mutable std::optional<std::optional<VoxelFit>> voxels_;  ///< empty until looked for
};

}  // namespace deltamesh
