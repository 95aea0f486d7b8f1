// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Faces that lie in no cube of a grid, as an ordinary mesh, some of whose vertices are the surface's
// [GRD-11].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "deltamesh/result.h"
#include "entropy/coder/counted_bit.h"
#include "entropy/coder/number_model.h"
#include "format/predictive_parameters.h"
#include "grid/surface.h"
#include "positions/blend/blend.h"

namespace deltamesh::grid {

struct RestSize {
  std::uint32_t vertices = 0;
  std::uint32_t triangles = 0;
};

/// Coordinates of the rest are whole floats while they are decoded.
inline constexpr std::uint32_t kMostRestCells = 1U << 24;

/// A mesh of its own on the lattice of the grid.
struct RestMesh {
  std::vector<std::uint32_t> triangles;  ///< m x 3
  std::vector<Cell> cells;               ///< of the vertices
};

/// `faces`: as CONN's; `positions`: as POSN's, of PositionKind::kLattice. Errors: kTruncated, kInvalidStream
/// [CONN-*, POSN-*, GRD-11].
Result<RestMesh> read_rest(std::span<const std::byte> faces, std::span<const std::byte> positions,
                           const RestSize& size, const PositionLattice& lattice);

/// Finds the vertices of a surface by where they are.
class VertexFinder {
 public:
  /// `cells`: of the surface's vertices. Both must outlive it.
  VertexFinder(const Surface& surface, std::span<const Cell> cells, std::uint32_t levels);

  /// The vertex at this point of the lattice, or kNoVertex.
  std::uint32_t find(const Cell& cell) const noexcept;

 private:
  const Surface& surface_;
  std::span<const Cell> cells_;
  std::int32_t voxel_;
  std::vector<std::pair<Cell, std::uint32_t>> inner_;  ///< vertices inside cubes, ascending
};

struct RestModels {
  NumberModel vertices;
  NumberModel triangles;
  CountedBit is_shared;
};

/// The numbers of vertices and faces of the rest.
template <class Coder>
void code_rest_size(Coder& coder, RestSize& size, RestModels& models) {
  size.triangles = coder.number(size.triangles, models.triangles);
  size.vertices = coder.number(size.vertices, models.vertices);
}

/// Which of the rest's vertices are the surface's at the same point. `numbers`: of them all, in the whole
/// mesh: those of the surface, then the rest's own. A writer knows `numbers`. False where the surface has
/// none at a point.
template <class Coder>
bool code_shared(Coder& coder, std::span<const Cell> rest, const VertexFinder& finder, std::uint32_t own,
                 std::vector<std::uint32_t>& numbers, RestModels& models) {
  numbers.resize(rest.size());
  std::uint32_t next = own;
  for (std::size_t v = 0; v < rest.size(); ++v) {
    const bool is_shared = coder.bit(Coder::kWrites && numbers[v] < own, models.is_shared);
    const std::uint32_t number = is_shared ? finder.find(rest[v]) : next++;
    if (number == kNoVertex || (Coder::kWrites && number != numbers[v])) return false;
    numbers[v] = number;
  }
  return true;
}

}  // namespace deltamesh::grid
