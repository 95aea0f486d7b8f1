// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From a request to a lattice, by trials of the predictive coder.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "encoder/coded_geometry.h"
#include "predictive/blend.h"
#include "quality/bounds.h"
#include "topology/adjacency.h"

namespace deltamesh {

/// A mesh for the predictive coder. All members must outlive the trials.
struct PredictiveInput {
  std::span<const std::uint32_t> triangles;  ///< over geometric vertices, coding order
  const Adjacency& graph;                    ///< of `triangles`
  std::span<const Vec3> positions;           ///< n, relative to the mesh's origin
  Box box;                                   ///< of `positions`
};

class PredictiveTrials {
 public:
  PredictiveTrials(const PredictiveInput& input, const StreamFrame& frame);

  /// The smallest stream found that keeps `bounds`, at least one of which is set. Effort 0 takes the first
  /// lattice that does. Errors: kUnmetRequest.
  Result<GeometryChoice> keep_bounds(const Bounds& bounds, int effort) const;

  /// The finest lattice found whose stream is not longer. Errors: kUnmetRequest.
  Result<GeometryChoice> fit_bytes(std::uint64_t bytes) const;

  /// The cubic lattice of this step, model units, above 0.
  Result<GeometryChoice> code_step(double step) const;

  /// The step of 2^bits points along the longest side.
  double step_for_bits(int bits) const noexcept;

 private:
  struct Trial {
    PositionLattice lattice;
    std::vector<Cell> cells;
    Quality quality;
  };

  Result<Trial> try_step(double step) const;
  Result<GeometryChoice> code(Trial trial) const;
  double first_step(const Bounds& bounds) const noexcept;

  PredictiveInput input_;
  StreamFrame frame_;
  FaceStars stars_;
};

}  // namespace deltamesh
