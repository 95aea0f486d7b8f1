// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>

#include "base/broken_rule.h"
#include "base/large_vector.h"
#include "base/try.h"
#include "entropy/compact_reader.h"
#include "format/tags.h"
#include "format/vertex_positions.h"
#include "predictive/float_coder.h"
#include "predictive/lattice_coder.h"
#include "predictive/position_models.h"
#include "predictive/positions.h"
#include "predictive/voxel_coder.h"

namespace deltamesh {
namespace {

Error broken_positions(const char* message, const char* rule) noexcept {
  return broken_rule(message, rule, kTagPositions);
}

/// n x 3, from `at(v, axis)`. Room is made ready bit by bit, so that it is in the cache when it is filled.
template <class At>
std::vector<float> to_rows(std::size_t count, const At& at) {
  constexpr std::size_t kAtOnce = 1024;
  std::vector<float> rows;
  reserve_large(rows, 3 * count);
  for (std::size_t v = 0; v < count;) {
    const std::size_t end = std::min(count, v + kAtOnce);
    rows.resize(3 * end);
    for (float* row = rows.data() + 3 * v; v < end; ++v, row += 3)
      for (std::size_t axis = 0; axis < 3; ++axis) row[axis] = at(v, axis);
  }
  return rows;
}

std::vector<float> to_rows(std::span<const Cell> cells, const PositionLattice& lattice) {
  return to_rows(cells.size(), [&](std::size_t v, std::size_t axis) {
    return static_cast<float>(lattice.at(axis, cells[v][axis]));
  });
}

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

Result<LargeVector<Cell>> read_lattice_cells(CompactReader& reader, const KnownFaces& faces,
                                             const PositionLattice& lattice, const BlendTable& blends,
                                             bool guesses, const Learning<PositionModels>& learning) {
  const LatticeModels* const start = learning.start != nullptr ? learning.start->of_lattice() : nullptr;
  LatticeCoder coder(reader, faces, lattice.cells, blends, guesses, start);
  LargeVector<Cell> cells(faces.vertex_count());
  for (std::uint32_t v = 0; v < cells.size() && !reader.failed();) {
    const char* broken = coder.code_next(v, cells);
    if (broken == nullptr) continue;
    if (!reader.failed()) return broken_positions("a coordinate beyond the lattice", broken);
    break;
  }
  if (learning.end != nullptr) learning.end->lattice = coder.models(start);
  return cells;
}

Result<std::vector<float>> read_lattice(CompactReader& reader, const KnownFaces& faces,
                                        const PositionLattice& lattice, const BlendTable& blends,
                                        const Learning<PositionModels>& learning) {
  const bool guesses = reader.bits(0, 1) != 0;
  const bool patched = reader.bits(0, 1) != 0;
  DELTAMESH_TRY(const auto cells, read_lattice_cells(reader, faces, lattice, blends, guesses, learning));
  std::vector<Patch> patches;
  if (patched && !reader.failed() &&
      !code_patches(reader, patches, 3 * std::uint64_t{faces.vertex_count()}) && !reader.failed())
    return broken_positions("a coordinate to replace that is not there, or not finite", "POSN-11");
  DELTAMESH_CHECK(reader.finish(kTagPositions));
  std::vector<float> rows = to_rows(cells, lattice);
  deltamesh::apply(patches, rows);
  return rows;
}

/// What follows the coding order, of vertices numbered by it.
Result<std::vector<float>> read_in_order(CompactReader& reader, const FaceList& list,
                                         std::span<const std::uint32_t> order,
                                         const PredictiveParameters& parameters, const Box& box,
                                         const Learning<PositionModels>& learning) {
  if (parameters.kind == PositionKind::kVoxel)
    return read_voxels(reader, VoxelFaces(list, order, learning.start == nullptr), parameters, learning);
  const KnownFaces faces(list, order);
  BlendTable blends{};
  code_blends(reader, blends);
  if (parameters.kind == PositionKind::kFloats) return read_floats(reader, faces, blends, box);
  return read_lattice(reader, faces, parameters.lattice, blends, learning);
}

std::vector<float> in_decoded_order(std::span<const float> ordered, std::span<const std::uint32_t> order) {
  std::vector<float> rows(ordered.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      rows[3 * std::size_t{order[i]} + axis] = ordered[3 * i + axis];
  return rows;
}

}  // namespace

Result<std::vector<float>> read_positions(Payload payload, const FaceList& faces,
                                          const PredictiveParameters& parameters, const Box& box,
                                          const Learning<PositionModels>& learning) {
  if (faces.vertex_count == 0) {
    if (!payload.bytes.empty()) return broken_positions("positions without vertices", "POSN-1");
    return std::vector<float>{};
  }
  if (!payload.is_compact) return broken_positions("positions that are not in the compact form", "POSN-1");
  CompactReader reader(payload.bytes);
  CodingOrder coding_order{};
  if (!code_coding_order(reader, coding_order))
    return broken_positions("an order of vertices that is not known", "POSN-10");
  const auto order = ordered_vertices(faces, coding_order);
  DELTAMESH_TRY(auto ordered, read_in_order(reader, faces, order, parameters, box, learning));
  if (!order.empty()) ordered = in_decoded_order(ordered, order);
  DELTAMESH_CHECK(check_finite(ordered));
  return ordered;
}

}  // namespace deltamesh
