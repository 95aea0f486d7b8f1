// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/memory/large_vector.h"
#include "base/try.h"
#include "format/vertex_positions.h"
#include "positions/lattice/coder.h"
#include "positions/ordered_read.h"
#include "positions/positions.h"

namespace deltamesh {
namespace {

Result<LargeVector<Cell>> read_lattice_cells(CompactReader& reader, const KnownFaces& faces,
                                             const PositionLattice& lattice, const BlendTable& blends,
                                             bool guesses, const Learning<LatticeModels>& learning) {
  LatticeCoder coder(reader, faces, lattice.cells, blends, guesses, learning.start);
  LargeVector<Cell> cells(faces.vertex_count());
  for (std::uint32_t v = 0; v < cells.size() && !reader.failed();) {
    const char* broken = coder.code_next(v, cells);
    if (broken == nullptr) continue;
    if (!reader.failed()) return broken_positions("a coordinate beyond the lattice", broken);
    break;
  }
  if (learning.end != nullptr) *learning.end = coder.models(learning.start);
  return cells;
}

Result<std::vector<float>> read_lattice(CompactReader& reader, const KnownFaces& faces,
                                        const PositionLattice& lattice,
                                        const Learning<LatticeModels>& learning) {
  BlendTable blends{};
  code_blends(reader, blends);
  const bool guesses = reader.bits(0, 1) != 0;
  const bool has_replacements = reader.bits(0, 1) != 0;
  DELTAMESH_TRY(const auto cells, read_lattice_cells(reader, faces, lattice, blends, guesses, learning));
  std::vector<Replacement> replacements;
  if (has_replacements && !reader.failed() &&
      !code_replacements(reader, replacements, 3 * std::uint64_t{faces.vertex_count()}) && !reader.failed())
    return broken_positions("a replacement is out of range or not finite", "POSN-11");
  DELTAMESH_CHECK(reader.finish(kTagPositions));
  std::vector<float> rows = to_rows(cells, lattice);
  deltamesh::apply(replacements, rows);
  return rows;
}

Result<std::vector<float>> read_lattice_positions(std::span<const std::byte> bytes, const FaceList& list,
                                                  const PositionLattice& lattice,
                                                  const Learning<LatticeModels>& learning) {
  return read_in_order(
      bytes, [&](CompactReader& reader, CodingOrder coding_order, std::vector<std::uint32_t>& order) {
        return read_lattice(reader, known_in_order(list, coding_order, order), lattice, learning);
      });
}

}  // namespace

Result<std::vector<float>> read_positions(std::span<const std::byte> payload, const FaceList& faces,
                                          const PredictiveParameters& parameters, const Box& box,
                                          const Learning<LatticeModels>& learning) {
  if (faces.vertex_count == 0) {
    if (!payload.empty()) return broken_positions("positions without vertices", "POSN-1");
    return std::vector<float>{};
  }
  DELTAMESH_TRY(auto rows, parameters.kind == PositionKind::kLattice
                               ? read_lattice_positions(payload, faces, parameters.lattice, learning)
                               : read_float_positions(payload, faces, box));
  DELTAMESH_CHECK(check_finite(rows));
  return rows;
}

}  // namespace deltamesh
