// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Meshes in the cubes of a grid.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "field/marching_cubes.h"
#include "grid/cube/cube.h"
#include "grid/grid.h"
#include "support/random.h"

namespace deltamesh::test {

struct CellMesh {
  std::vector<std::uint32_t> triangles;
  std::vector<Cell> cells;
  PredictiveParameters parameters;
};

/// On a grid of `nodes` on every axis.
inline PredictiveParameters voxel_parameters(std::uint32_t nodes, std::uint32_t levels) {
  PredictiveParameters parameters{.kind = PositionKind::kVoxel, .lattice = {}, .levels = levels};
  parameters.lattice.cells.fill((nodes - 1) * 2 * levels);
  return parameters;
}

/// Where `field` is 0, by marching cubes of edge 1. `field`: of a node, negative inside.
inline scenes::Surface marched(const std::function<float(int, int, int)>& field, std::uint32_t nodes) {
  std::vector<float> layer(std::size_t{nodes} * nodes);
  const scenes::Lattice lattice{.nodes = {nodes, nodes, nodes}, .voxel = 1, .base = {}};
  return march_cubes(lattice, [&](std::uint32_t i) {
    for (std::uint32_t j = 0; j < nodes; ++j)
      for (std::uint32_t k = 0; k < nodes; ++k)
        layer[std::size_t{j} * nodes + k] =
            field(static_cast<int>(i), static_cast<int>(j), static_cast<int>(k));
    return std::span<const float>(layer);
  });
}

/// The same, on levels.
inline CellMesh surface_of(const std::function<float(int, int, int)>& field, std::uint32_t nodes,
                           std::uint32_t levels) {
  const scenes::Surface surface = marched(field, nodes);
  CellMesh mesh{surface.triangles, {}, voxel_parameters(nodes, levels)};
  for (std::size_t v = 0; v < surface.positions.size(); v += 3) {
    Cell& cell = mesh.cells.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float node = std::floor(surface.positions[v + axis]);
      const float part = surface.positions[v + axis] - node;
      cell[axis] = static_cast<std::int32_t>(node) * 2 * static_cast<std::int32_t>(levels);
      if (part > 0) cell[axis] += 2 * static_cast<std::int32_t>(part * static_cast<float>(levels)) + 1;
    }
  }
  return mesh;
}

/// Waves, cut by a node plane of the grid, and some noise.
inline CellMesh wavy_surface(std::uint32_t nodes, std::uint32_t levels) {
  RandomBits random(7);
  return surface_of(
      [&](int i, int j, int k) {
        const float noise = static_cast<float>(random() % 1000) / 2000;
        if (i % 19 == 7 && j > 9) return scenes::kUnobserved;
        return static_cast<float>(k) - 11.3F - 4 * std::sin(static_cast<float>(i) / 5) -
               3 * std::cos(static_cast<float>(j) / 4) + noise;
      },
      nodes, levels);
}

/// Any triangles over edges and insides of cubes: patterns that no table has.
inline CellMesh random_faces(std::uint32_t seed, std::uint32_t nodes, std::uint32_t levels,
                             std::uint32_t faces) {
  RandomBits random(seed);
  const auto w = static_cast<std::int32_t>(2 * levels);
  CellMesh mesh{{}, {}, voxel_parameters(nodes, levels)};
  for (std::uint32_t f = 0; f < faces; ++f) {
    Cell cube{};
    for (std::int32_t& at : cube) at = static_cast<std::int32_t>(random() % (nodes - 1)) * w;
    const std::uint32_t first = random() % 13;
    const std::array<std::uint32_t, 3> slots = {first, (first + 1 + random() % 5) % 13,
                                                (first + 6 + random() % 6) % 13};
    for (const std::uint32_t slot : slots) {
      Cell cell = cube;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const unsigned corner = slot < grid::kEdges ? grid::first_corner(slot) : 0;
        if ((corner >> axis & 1) != 0) cell[axis] += w;
        if (slot == grid::kInside || slot / 4 == axis)
          cell[axis] += 1 + 2 * static_cast<std::int32_t>(random() % levels);
      }
      // One vertex to an edge.
      std::uint32_t found = 0;
      const auto place = [&](const Cell& c) { return std::array{c[0] / w, c[1] / w, c[2] / w}; };
      const auto on = [&](const Cell& c) { return std::array{c[0] % w == 0, c[1] % w == 0, c[2] % w == 0}; };
      while (found < mesh.cells.size() &&
             (place(mesh.cells[found]) != place(cell) || on(mesh.cells[found]) != on(cell)))
        ++found;
      if (found == mesh.cells.size()) mesh.cells.push_back(cell);
      mesh.triangles.push_back(found);
    }
  }
  return mesh;
}

}  // namespace deltamesh::test
