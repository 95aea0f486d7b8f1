// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From a request to a lattice, by trials of the predictive coder.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "encoder/coded_geometry.h"
#include "encoder/lazy_graph.h"
#include "predictive/blend.h"
#include "predictive/patches.h"
#include "predictive/voxel_fit.h"
#include "quality/bounds.h"
#include "topology/mesh_edges.h"

namespace deltamesh {

/// A mesh for the predictive coder. All members must outlive the trials.
struct PredictiveInput {
  std::span<const std::uint32_t> triangles;  ///< over geometric vertices, coding order
  const LazyGraph& graph;                    ///< of `triangles`
  const MeshEdges& edges;                    ///< of `triangles`
  std::span<const Vec3> positions;           ///< n, relative to the mesh's origin
  Box box;                                   ///< of `positions`
};

class PredictiveTrials {
 public:
  /// `effort`: 0 (one pass, the first lattice that does) to 9.
  PredictiveTrials(const PredictiveInput& input, const StreamFrame& frame, int effort);

  /// Whether keep_bounds() is likely to find a smaller stream than highpass coding, from statistics of the
  /// mesh.
  bool suits(const Bounds& bounds) const;

  /// The smallest stream found that keeps `bounds`, at least one of which is set; there always is one.
  Result<GeometryChoice> keep_bounds(const Bounds& bounds) const;

  /// The finest lattice found whose stream is not longer. Errors: kUnmetRequest.
  Result<GeometryChoice> fit_bytes(std::uint64_t bytes) const;

  /// Every position to the last bit.
  GeometryChoice code_exactly() const;

  /// The cubic lattice of this step, model units, above 0. Errors: kInvalidArgument where that takes more
  /// than kMostCells.
  Result<GeometryChoice> code_step(double step) const;

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
  GeometryChoice code(const Trial& trial) const;
  GeometryChoice code_floats() const;
  double first_step(const Bounds& bounds) const noexcept;
  /// Looked for when first asked for.
  const std::optional<VoxelFit>& voxels() const;
  /// Whether most vertices are on edges of voxels that are not much finer than the bounds' lattice, and faces
  /// no larger.
  bool are_voxels_enough(const Bounds& bounds) const;
  /// On a cubic lattice but for `axes` with steps of their own; empty where none keeps the bounds.
  std::optional<Trial> keep_on_lattice(const Bounds& bounds, const std::array<AxisGrid, 3>& axes) const;
  std::optional<Trial> keep_on_voxels(const Bounds& bounds, const VoxelFit& fit) const;
  Result<GeometryChoice> fit_lattice(std::uint64_t bytes) const;
  std::optional<GeometryChoice> fit_voxel_levels(std::uint64_t bytes, const VoxelFit& voxels) const;

  PredictiveInput input_;
  StreamFrame frame_;
  int effort_;
  FaceList faces_;
  AxisValues values_;
  mutable std::optional<std::optional<VoxelFit>> voxels_;  ///< empty until looked for
};

}  // namespace deltamesh
