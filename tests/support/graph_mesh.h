// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Small meshes as the geometry coder sees them, for tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/numbers/vec3.h"
#include "laplacian/anchors/anchor_sequence.h"
#include "support/grid_triangles.h"
#include "topology/adjacency.h"

namespace deltamesh::test {

struct GraphMesh {
  std::vector<Vec3> positions{};
  std::vector<std::uint32_t> triangles{};
  Adjacency graph{};
  Components components{};
  Box box{};
};

/// Derives graph, components and box from positions and triangles.
inline GraphMesh finish(GraphMesh mesh) {
  mesh.graph = build_adjacency(mesh.triangles, static_cast<std::uint32_t>(mesh.positions.size()));
  mesh.components = find_components(mesh.graph);
  mesh.box = Box::around(mesh.positions);
  return mesh;
}

/// So many anchors in the solved components, at least one in each, and those of the others; ascending.
inline std::vector<std::uint32_t> anchors_of(const GraphMesh& mesh, std::uint32_t count) {
  return AnchorSequence(mesh.graph, mesh.components).first(mesh.graph, count).vertices;
}

/// Appends a bumpy sheet of `width` x `height` vertices, 1 apart, at `corner`.
inline void add_sheet(GraphMesh& mesh, std::uint32_t width, std::uint32_t height, const Vec3& corner) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      const double bump = std::sin(0.7 * x) * std::cos(0.4 * y) + 0.05 * ((x * 7 + y * 13) % 5);
      mesh.positions.push_back(corner + Vec3{static_cast<double>(x), static_cast<double>(y), bump});
    }
  }
  const auto triangles = grid_triangles(width, height, first);
  mesh.triangles.insert(mesh.triangles.end(), triangles.begin(), triangles.end());
}

inline GraphMesh sheet(std::uint32_t width, std::uint32_t height) {
  GraphMesh mesh;
  add_sheet(mesh, width, height, {});
  return finish(std::move(mesh));
}

/// A vertex joined to `rim` others, which form a closed ring around it.
inline GraphMesh fan(std::uint32_t rim) {
  GraphMesh mesh;
  mesh.positions.push_back({0, 0, 1});
  for (std::uint32_t i = 0; i < rim; ++i) {
    const double angle = 6.283185307179586 * i / rim;
    mesh.positions.push_back({std::cos(angle), std::sin(angle), 0});
    mesh.triangles.insert(mesh.triangles.end(), {0, 1 + i, 1 + (i + 1) % rim});
  }
  return finish(std::move(mesh));
}

/// The same shape with the vertices of all components mixed.
inline GraphMesh renumbered(const GraphMesh& mesh) {
  GraphMesh result;
  const std::size_t n = mesh.positions.size();
  std::size_t stride = 1009;
  while (n % stride == 0) stride += 2;
  std::vector<std::uint32_t> place(n);
  result.positions.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    place[i] = static_cast<std::uint32_t>(i * stride % n);
    result.positions[place[i]] = mesh.positions[i];
  }
  for (const std::uint32_t v : mesh.triangles) result.triangles.push_back(place[v]);
  return finish(std::move(result));
}

/// Two sheets, a lone triangle, a tetrahedron and an isolated vertex.
inline GraphMesh fragments() {
  GraphMesh mesh;
  add_sheet(mesh, 9, 7, {});
  mesh.positions.insert(mesh.positions.end(), {{20, 0, 0}, {21, 0, 0}, {20, 1, 3}});
  mesh.triangles.insert(mesh.triangles.end(), {63, 64, 65});
  add_sheet(mesh, 4, 2, {-15, 3, 2});
  mesh.positions.insert(mesh.positions.end(), {{0, 0, 9}, {1, 0, 9}, {0, 1, 9}, {0, 0, 10}});
  mesh.triangles.insert(mesh.triangles.end(), {74, 75, 76, 74, 76, 77, 74, 77, 75, 75, 77, 76});
  mesh.positions.push_back({5, 5, 5});
  return finish(std::move(mesh));
}

}  // namespace deltamesh::test
