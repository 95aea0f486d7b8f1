// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "entropy/compact_writer.h"
#include "predictive/blend_fit.h"
#include "predictive/lattice_coder.h"
#include "predictive/positions.h"

namespace deltamesh {

std::vector<std::byte> write_positions(const FaceStars& stars, std::span<const Cell> cells,
                                       const PositionLattice& lattice) {
  if (cells.empty()) return {};
  CompactWriter writer;
  BlendTable blends = fit_blends(stars, cells);
  code_blends(writer, blends);
  LatticeCoder coder(writer, stars, lattice.cells, blends);
  std::vector<Cell> coded(cells.begin(), cells.end());
  for (std::uint32_t v = 0; v < coded.size(); ++v) coder.code_vertex(v, coded);
  return writer.finish();
}

}  // namespace deltamesh
