// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/try.h"
#include "positions/floats/coder.h"
#include "positions/grid/coder.h"
#include "positions/models.h"
#include "positions/ordered_read.h"
#include "positions/positions.h"

namespace deltamesh {
namespace {

Result<std::vector<float>> read_floats(CompactReader& reader, const KnownFaces& faces,
                                       const BlendTable& blends, const Box& box) {
  FloatCoder coder(reader, faces, float_units(box), blends);
  LargeVector<Ordinals> floats(faces.vertex_count(), Ordinals{});
  for (std::uint32_t v = 0; v < floats.size() && !reader.failed(); ++v) {
    const char* broken = coder.code_vertex(v, floats);
    if (broken != nullptr && !reader.failed()) return broken_positions("not a finite float32", broken);
  }
  DELTAMESH_CHECK(reader.finish(kTagPositions));
  return to_rows(floats.size(), [&](std::size_t v, std::size_t axis) { return float_of(floats[v][axis]); });
}

/// In two interleaved sequences. What the coder remembers is gone when the cells are there.
Result<LargeVector<Cell>> read_voxel_cells(CompactReader& reader, const VoxelFaces& faces,
                                           const PredictiveParameters& parameters,
                                           const Learning<PositionModels>& learning) {
  VoxelCoder coder(reader, faces, parameters.lattice.cells, parameters.levels,
                   learning.start != nullptr ? learning.start->of_voxels() : nullptr);
  LargeVector<Cell> cells(faces.vertex_count());
  for (std::uint32_t step = 0; step < faces.steps() && !reader.failed(); ++step) {
    const char* broken = coder.code_step(step, cells);
    if (broken != nullptr && !reader.failed())
      return broken_positions("not a vertex of the voxel grid", broken);
  }
  if (learning.end != nullptr) learning.end->voxels = coder.models();
  return cells;
}

Result<std::vector<float>> read_voxels(CompactReader& reader, const VoxelFaces& faces,
                                       const PredictiveParameters& parameters,
                                       const Learning<PositionModels>& learning) {
  DELTAMESH_TRY(const auto cells, read_voxel_cells(reader, faces, parameters, learning));
  DELTAMESH_CHECK(reader.finish(kTagPositions));
  return to_rows(cells, parameters.lattice);
}

}  // namespace

Result<std::vector<float>> read_rare_positions(std::span<const std::byte> bytes, const FaceList& list,
                                               const PredictiveParameters& parameters, const Box& box,
                                               const Learning<PositionModels>& learning) {
  const auto read = [&](CompactReader& reader, CodingOrder coding_order,
                        std::vector<std::uint32_t>& order) -> Result<std::vector<float>> {
    if (parameters.kind == PositionKind::kVoxel) {
      order = ordered_vertices(list, coding_order);
      return read_voxels(reader, VoxelFaces(list, order, learning.start == nullptr), parameters, learning);
    }
    const KnownFaces faces = known_in_order(list, coding_order, order);
    BlendTable blends{};
    code_blends(reader, blends);
    return read_floats(reader, faces, blends, box);
  };
  return read_in_order(bytes, read);
}

}  // namespace deltamesh
