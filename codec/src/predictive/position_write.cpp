// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "entropy/compact_writer.h"
#include "predictive/blend_fit.h"
#include "predictive/float_coder.h"
#include "predictive/lattice_coder.h"
#include "predictive/positions.h"
#include "predictive/voxel_coder.h"

namespace deltamesh {

std::vector<std::byte> write_positions(const FaceStars& stars, std::span<const Cell> cells,
                                       const PredictiveParameters& parameters, bool guesses) {
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
  writer.bits(guesses ? 1 : 0, 1);
  return write_with(LatticeCoder(writer, stars, lattice.cells, blends, guesses));
}

std::vector<std::byte> write_floats(const FaceStars& stars, std::span<const Vec3> positions, const Box& box) {
  if (positions.empty()) return {};
  const std::array<int, 3> units = float_units(box);
  std::vector<Ordinals> floats(positions.size());
  std::vector<Cell> cells(positions.size());
  for (std::size_t v = 0; v < floats.size(); ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      floats[v][axis] = ordinal_of(static_cast<float>(positions[v][axis]));
      cells[v][axis] = fixed_of(floats[v][axis], units[axis]);
    }
  }
  CompactWriter writer;
  BlendTable blends = fit_blends(stars, cells);
  code_blends(writer, blends);
  FloatCoder coder(writer, stars, units, blends);
  for (std::uint32_t v = 0; v < floats.size(); ++v) coder.code_vertex(v, floats);
  return writer.finish();
}

}  // namespace deltamesh
