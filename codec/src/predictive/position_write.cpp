// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "entropy/compact_writer.h"
#include "predictive/blend_fit.h"
#include "predictive/lattice_coder.h"
#include "predictive/positions.h"
#include "predictive/voxel_coder.h"

namespace deltamesh {

std::vector<std::byte> write_positions(const FaceStars& stars, std::span<const Cell> cells,
                                       const PredictiveParameters& parameters) {
  if (cells.empty()) return {};
  CompactWriter writer;
  BlendTable blends = fit_blends(stars, cells);
  code_blends(writer, blends);
  std::vector<Cell> coded(cells.begin(), cells.end());
  const auto write_with = [&](auto coder) {
    for (std::uint32_t v = 0; v < coded.size(); ++v) coder.code_vertex(v, coded);
    return writer.finish();
  };
  const PositionLattice& lattice = parameters.lattice;
  if (parameters.kind == PositionKind::kVoxel)
    return write_with(VoxelCoder(writer, stars, lattice.cells, parameters.levels, blends));
  return write_with(LatticeCoder(writer, stars, lattice.cells, blends));
}

}  // namespace deltamesh
