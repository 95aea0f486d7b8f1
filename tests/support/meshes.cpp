// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "support/meshes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <random>
#include <utility>

#include "support/attribute_of.h"
#include "support/grid_triangles.h"

namespace deltamesh::test {
namespace {

Mesh mesh_of(std::vector<float> positions, std::vector<std::uint32_t> triangles) {
  Mesh mesh;
  mesh.positions = std::move(positions);
  mesh.triangles = std::move(triangles);
  return mesh;
}

Mesh fragments(std::uint32_t count) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto x = static_cast<float>(3 * i);
    mesh.positions.insert(mesh.positions.end(), {x, 0, 0, x + 1, 0.5F, 0, x, 1, 0.25F});
    mesh.triangles.insert(mesh.triangles.end(), {3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

/// A strip whose two halves meet at a seam: equal positions, other vertices.
Mesh seamed_strip() {
  Mesh mesh = bumpy_grid(6, 2);
  const auto n = static_cast<std::uint32_t>(mesh.vertex_count());
  for (std::uint32_t row = 0; row < 3; ++row) {
    const std::uint32_t v = row * 7 + 3;
    const float p[] = {mesh.positions[3 * v], mesh.positions[3 * v + 1], mesh.positions[3 * v + 2]};
    mesh.positions.insert(mesh.positions.end(), p, p + 3);
  }
  for (std::size_t f = 0; f < mesh.triangle_count(); ++f) {
    float right = 0;
    for (std::size_t c = 0; c < 3; ++c)
      right = std::max(right, mesh.positions[3 * mesh.triangles[3 * f + c]]);
    if (right <= 3) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      std::uint32_t& v = mesh.triangles[3 * f + c];
      if (mesh.positions[3 * v] == 3) v = n + v / 7;
    }
  }
  return mesh;
}

Mesh scaled(Mesh mesh, float scale) {
  for (float& x : mesh.positions) x *= scale;
  return mesh;
}

}  // namespace

Mesh tetrahedron() {
  return mesh_of({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3});
}

Mesh bumpy_grid(std::uint32_t columns, std::uint32_t rows) {
  Mesh mesh;
  for (std::uint32_t y = 0; y <= rows; ++y) {
    for (std::uint32_t x = 0; x <= columns; ++x) {
      const auto bump = static_cast<float>((x * 7 + y * 13 + x * y) % 11) / 16.0F;
      mesh.positions.insert(mesh.positions.end(), {static_cast<float>(x), static_cast<float>(y), bump});
    }
  }
  mesh.triangles = grid_triangles(columns + 1, rows + 1);
  return mesh;
}

Mesh attributed_grid(std::uint32_t columns, std::uint32_t rows) {
  Mesh mesh = bumpy_grid(columns, rows);
  std::vector<float> normals;
  std::vector<float> uvs;
  std::vector<std::uint8_t> colors;
  std::vector<std::uint16_t> scores;
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    const float z = mesh.positions[3 * i + 2];
    const float scale = 1 / std::sqrt(1 + z * z);
    normals.insert(normals.end(), {z * scale, 0, scale});
    uvs.insert(uvs.end(), {mesh.positions[3 * i] / 10, z});
    colors.insert(colors.end(), {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i / 3), 200});
    scores.push_back(static_cast<std::uint16_t>(i * i));
  }
  mesh.attributes.push_back(attribute_of(AttributeKind::kNormal, ComponentType::kF32, 3, "normal", normals));
  mesh.attributes.push_back(attribute_of(AttributeKind::kColor, ComponentType::kU8, 3, "color", colors));
  mesh.attributes.push_back(attribute_of(AttributeKind::kUv, ComponentType::kF32, 2, "uv", uvs));
  mesh.attributes.push_back(attribute_of(AttributeKind::kGeneric, ComponentType::kU16, 1, "score", scores));
  return mesh;
}

std::vector<NamedMesh> awkward_meshes() {
  const Mesh grid = bumpy_grid(5, 4);
  Mesh flipped = grid;
  std::swap(flipped.triangles[3], flipped.triangles[4]);
  Mesh doubled = grid;
  doubled.triangles.insert(doubled.triangles.end(), grid.triangles.begin(), grid.triangles.begin() + 30);
  Mesh far = attributed_grid(6, 6);
  far.origin = {500000, 5100000, 120.5};
  Mesh isolated = grid;
  isolated.positions.insert(isolated.positions.end(), {9, 9, 9, -4, 0, 0, 9, 9, 9});
  std::vector<float> one_place(3 * 12, 0.5F);
  Mesh collapsed = mesh_of(one_place, {0, 1, 2, 2, 3, 4, 5, 6, 7, 8, 9, 10, 1, 2, 11});
  return {
      {"empty", {}},
      {"one vertex", mesh_of({1, 2, 3}, {})},
      {"one triangle", mesh_of({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2})},
      {"tetrahedron", tetrahedron()},
      {"grid", grid},
      {"flat grid", mesh_of({0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0, 0, 2, 0, 1, 2, 0, 2, 2, 0},
                            {0, 1, 3, 1, 4, 3, 1, 2, 4, 2, 5, 4, 3, 4, 6, 4, 7, 6, 4, 5, 7, 5, 8, 7})},
      {"attributes", attributed_grid(8, 5)},
      {"far from the origin", far},
      {"seam", seamed_strip()},
      {"isolated vertices", isolated},
      {"fragments", fragments(40)},
      {"flipped face", flipped},
      {"duplicate faces", doubled},
      {"degenerate faces",
       mesh_of({0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 2, 1}, {0, 1, 2, 1, 1, 3, 2, 2, 2, 1, 3, 2, 0, 3, 0})},
      {"three faces on an edge",
       mesh_of({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1}, {0, 1, 2, 1, 0, 3, 0, 1, 4})},
      {"bow-tie", mesh_of({0, 0, 0, 1, 1, 0, 1, -1, 0, -1, 1, 0, -1, -1, 0}, {0, 2, 1, 0, 3, 4})},
      {"two sides of one triangle", mesh_of({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2, 0, 2, 1})},
      {"all in one place", collapsed},
      {"tiny", scaled(grid, 1e-30F)},
      {"huge", scaled(grid, 1e30F)},
      {"denormal", scaled(grid, 1e-44F)},
  };
}

Shuffled shuffled(const Mesh& mesh, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<std::uint32_t> order(mesh.vertex_count());
  std::iota(order.begin(), order.end(), 0U);
  std::shuffle(order.begin(), order.end(), random);
  std::vector<std::uint32_t> inverse(order.size());
  Mesh result;
  result.origin = mesh.origin;
  for (std::uint32_t v = 0; v < order.size(); ++v) {
    inverse[order[v]] = v;
    for (std::size_t k = 0; k < 3; ++k) result.positions.push_back(mesh.positions[3 * order[v] + k]);
  }
  for (std::size_t t = mesh.triangle_count(); t-- > 0;)
    for (std::size_t k = 0; k < 3; ++k)
      result.triangles.push_back(inverse[mesh.triangles[3 * t + (k + t) % 3]]);
  for (const Attribute& from : mesh.attributes) {
    Attribute& to = result.attributes.emplace_back(from);
    const std::size_t size = from.components * component_size(from.type);
    for (std::size_t v = 0; v < order.size(); ++v)
      std::memcpy(to.values.data() + v * size, from.values.data() + order[v] * size, size);
  }
  return {std::move(result), std::move(order)};
}

std::vector<std::array<std::uint32_t, 3>> canonical_faces(std::span<const std::uint32_t> triangles) {
  std::vector<std::array<std::uint32_t, 3>> faces;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    std::array<std::uint32_t, 3> face{triangles[i], triangles[i + 1], triangles[i + 2]};
    std::array<std::uint32_t, 3> best = face;
    for (int turn = 0; turn < 2; ++turn) {
      std::rotate(face.begin(), face.begin() + 1, face.end());
      best = std::min(best, face);
    }
    faces.push_back(best);
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace deltamesh::test
