// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A mesh coded by the predictive coder on one lattice or another.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "encoder/source_geometry.h"
#include "positions/grid/fit.h"
#include "positions/lattice/axis_values.h"
#include "positions/lattice/replacements.h"
#include "search/bounds.h"
#include "search/coded_geometry.h"

namespace deltamesh {

struct PositionModels;

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
  PredictiveTrials(const EncodeOptions& options, const SourceGeometry& source, const StreamRest& rest);

  LatticeTrial try_lattice(const PositionLattice& lattice, const Bounds& bounds = {}) const;
  /// On voxels with so many levels along an edge; empty where they have no room for so many.
  std::optional<LatticeTrial> try_levels(const VoxelFit& fit, std::uint32_t levels,
                                         const Bounds& bounds = {}) const;

  CodedGeometry code(const LatticeTrial& trial) const;
  /// The cubic lattice of this step, model units, above 0. Errors: kInvalidArgument where that takes more
  /// than kMostCells.
  Result<CodedGeometry> code_step(double step) const;
  /// Every position to the last bit.
  CodedGeometry code_exactly() const;

  /// The step of 2^bits points along the longest side.
  double step_for_bits(int bits) const noexcept;
  /// The axes whose coordinates all are on a grid, of steps of at least `finest`.
  std::array<AxisGrid, 3> axes(double finest) const { return fit_axes(values_, source_.box, finest); }
  /// The voxels that the mesh was cut from; that of the starting states, or looked for when first
  /// asked for.
  const std::optional<VoxelFit>& voxels() const;

  /// Levels of the voxels that starting states are of; 0 without.
  std::uint32_t usual_levels() const noexcept;

  const SourceGeometry& source() const noexcept { return source_; }
  int effort() const noexcept { return options_.effort; }
  /// Size of the whole stream, bytes.
  std::uint64_t bytes_with(const CodedGeometry& geometry) const { return rest_.bytes_with(geometry); }

 private:
  LatticeTrial measured(PredictiveParameters parameters, std::vector<Cell> cells, const Bounds& bounds) const;
  CodedGeometry code_floats() const;
  const PositionModels* start() const noexcept;
  bool has_usual_voxels() const noexcept;
  std::optional<VoxelFit> fit_usual_voxels() const;
  FaceList faces() const noexcept {
    return {source_.triangles, static_cast<std::uint32_t>(source_.positions.size())};
  }

  const EncodeOptions& options_;
  const SourceGeometry& source_;
  StreamRest rest_;
  AxisValues values_;
  mutable std::optional<std::optional<VoxelFit>> voxels_;  ///< empty until looked for
};

}  // namespace deltamesh
