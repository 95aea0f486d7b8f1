// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Small meshes for tests, each with one awkward or plain trait.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "deltamesh/mesh.h"

namespace deltamesh::test {

struct NamedMesh {
  std::string name;
  Mesh mesh;
};

Mesh tetrahedron();

/// A bumpy open grid of (columns + 1) x (rows + 1) vertices in [0, columns] x [0, rows].
Mesh bumpy_grid(std::uint32_t columns, std::uint32_t rows);

/// bumpy_grid with normals, colours, texture coordinates and a named scalar.
Mesh attributed_grid(std::uint32_t columns, std::uint32_t rows);

/// Many small meshes: empty, isolated vertices, one triangle, non-manifold, degenerate, duplicate and flipped
/// faces, bow-tie, seams, many components, extreme range, flat, all vertices in one place.
std::vector<NamedMesh> awkward_meshes();

struct Shuffled {
  Mesh mesh;
  std::vector<std::uint32_t> order;  ///< the old vertex of each
};

/// Vertices in another order, by `seed`; triangles in reverse order and rotated.
Shuffled shuffled(const Mesh& mesh, std::uint32_t seed);

/// The triangles of `mesh` with each rotated to start at its smallest index, sorted: equal for meshes with
/// the same oriented faces.
std::vector<std::array<std::uint32_t, 3>> canonical_faces(std::span<const std::uint32_t> triangles);

}  // namespace deltamesh::test
