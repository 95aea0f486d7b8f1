// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From a request to a lattice, by trials of the predictive coder.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "encoder/coded_geometry.h"
#include "encoder/source_geometry.h"
#include "predictive/blend.h"
#include "predictive/patches.h"
#include "predictive/voxel_fit.h"
#include "quality/bounds.h"

namespace deltamesh {

class PredictiveTrials {
 public:
  /// The arguments must outlive the trials.
  PredictiveTrials(const EncodeOptions& options, const SourceGeometry& source, const StreamRest& rest);

  /// Whether keep_bounds() is likely to find a smaller stream than highpass coding, from statistics of the
  /// mesh.
  bool suits(const Bounds& bounds) const;

  /// The smallest stream found that keeps `bounds`, at least one of which is set; there always is one.
  Result<CodedGeometry> keep_bounds(const Bounds& bounds) const;

  /// The finest lattice found whose stream is not longer. Errors: kUnmetRequest.
  Result<CodedGeometry> fit_bytes(std::uint64_t bytes) const;

  /// Every position to the last bit.
  CodedGeometry code_exactly() const;

  /// The cubic lattice of this step, model units, above 0. Errors: kInvalidArgument where that takes more
  /// than kMostCells.
  Result<CodedGeometry> code_step(double step) const;

  /// The step of 2^bits points along the longest side.
  double step_for_bits(int bits) const noexcept;

 private:
  struct Trial {
    PredictiveParameters parameters;
    std::vector<Cell> cells;
    Quality quality{};             ///< with VDE only where that is bounded
    std::vector<Patch> patches{};  ///< of an exact lattice
  };

  Trial measured(PredictiveParameters parameters, std::vector<Cell> cells, const Bounds& bounds) const;
  Trial try_lattice(const PositionLattice& lattice, const Bounds& bounds = {}) const;
  /// Empty where the voxels have no room for so many.
  std::optional<Trial> try_levels(const VoxelFit& fit, std::uint32_t levels, const Bounds& bounds = {}) const;
  CodedGeometry code(const Trial& trial) const;
  CodedGeometry code_floats() const;
  double first_step(const Bounds& bounds) const noexcept;
  /// Looked for when first asked for.
  const std::optional<VoxelFit>& voxels() const;
  /// Whether most vertices are on edges of voxels that are not much finer than the bounds' lattice, and faces
  /// no larger.
  bool are_voxels_enough(const Bounds& bounds) const;
  /// On a cubic lattice but for `axes` with steps of their own; empty where none keeps the bounds.
  std::optional<Trial> keep_on_lattice(const Bounds& bounds, const std::array<AxisGrid, 3>& axes) const;
  std::optional<Trial> keep_on_voxels(const Bounds& bounds, const VoxelFit& fit) const;
  Result<CodedGeometry> fit_lattice(std::uint64_t bytes) const;
  std::optional<CodedGeometry> fit_voxel_levels(std::uint64_t bytes, const VoxelFit& voxels) const;

  const EncodeOptions& options_;
  const SourceGeometry& source_;
  StreamRest rest_;
  FaceList faces_;
  AxisValues values_;
  mutable std::optional<std::optional<VoxelFit>> voxels_;  ///< empty until looked for
};

}  // namespace deltamesh
