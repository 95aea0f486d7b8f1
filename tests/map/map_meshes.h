// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Meshes and comparisons for the tests of maps.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "deltamesh/map/description.h"
#include "deltamesh/map/part.h"
#include "deltamesh/mesh.h"

namespace deltamesh::test {

/// A face by the bits of its corners' positions, the least first, the others in turn.
using FaceBits = std::array<std::array<std::uint32_t, 3>, 3>;

/// Ascending; one zero.
inline std::vector<FaceBits> face_bits(const Mesh& mesh) {
  std::vector<FaceBits> faces;
  for (std::size_t f = 0; f < mesh.triangle_count(); ++f) {
    FaceBits face{};
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t k = 0; k < 3; ++k)
        face[c][k] = std::bit_cast<std::uint32_t>(
            mesh.positions[3 * std::size_t{mesh.triangles[3 * f + c]} + k] + 0.0F);
    FaceBits least = face;
    for (int turn = 0; turn < 2; ++turn) {
      std::rotate(face.begin(), face.begin() + 1, face.end());
      least = std::min(least, face);
    }
    faces.push_back(least);
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// What does not change where vertices move and are renumbered.
struct TopologyCounts {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t open_edges = 0;
  std::size_t components = 0;

  bool operator==(const TopologyCounts&) const = default;
};

inline TopologyCounts topology_counts(const Mesh& mesh) {
  std::set<std::uint32_t> vertices(mesh.triangles.begin(), mesh.triangles.end());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  std::vector<std::uint32_t> parent(mesh.vertex_count());
  for (std::uint32_t v = 0; v < parent.size(); ++v) parent[v] = v;
  const auto find = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::uint32_t a = mesh.triangles[i];
    const std::uint32_t b = mesh.triangles[i % 3 == 2 ? i - 2 : i + 1];
    edges.push_back(std::minmax(a, b));
    parent[find(a)] = find(b);
  }
  std::sort(edges.begin(), edges.end());
  TopologyCounts counts{.vertices = vertices.size(), .faces = mesh.triangle_count()};
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t j = i;
    while (j < edges.size() && edges[j] == edges[i]) ++j;
    ++counts.edges;
    counts.open_edges += j - i == 1 ? 1 : 0;
    i = j;
  }
  for (const std::uint32_t v : vertices) counts.components += find(v) == v ? 1 : 0;
  return counts;
}

/// Vertices with equal positions become one.
inline Mesh welded(const Mesh& mesh) {
  std::vector<std::array<std::uint32_t, 3>> bits;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    std::array<std::uint32_t, 3> b{};
    for (std::size_t k = 0; k < 3; ++k) b[k] = std::bit_cast<std::uint32_t>(mesh.positions[3 * v + k] + 0.0F);
    bits.push_back(b);
  }
  auto sorted = bits;
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  Mesh result;
  for (const auto& b : sorted)
    for (const std::uint32_t x : b) result.positions.push_back(std::bit_cast<float>(x));
  for (const std::uint32_t v : mesh.triangles)
    result.triangles.push_back(
        static_cast<std::uint32_t>(std::lower_bound(sorted.begin(), sorted.end(), bits[v]) - sorted.begin()));
  return result;
}

/// Attributes of `mesh` as a map has them.
inline std::vector<MapAttribute> attributes_of(const Mesh& mesh) {
  std::vector<MapAttribute> attributes;
  for (const Attribute& a : mesh.attributes)
    attributes.push_back({a.kind, a.type, a.components, a.normalized, a.name});
  return attributes;
}

/// A wavy sheet of columns x rows quads 0.02 apart, with 3 colours of 8 bits; noise makes slivers.
inline Mesh wavy_sheet(std::uint32_t columns, std::uint32_t rows, std::uint32_t seed, double noise) {
  std::mt19937 random(seed);
  const auto uniform = [&] { return static_cast<double>(random() % 2001) / 1000 - 1; };
  Mesh mesh;
  Attribute color{AttributeKind::kColor, ComponentType::kU8, 3, true, "red", {}};
  for (std::uint32_t y = 0; y <= rows; ++y) {
    for (std::uint32_t x = 0; x <= columns; ++x) {
      const double u = 0.02 * x - 0.01 * columns;
      const double v = 0.02 * y - 0.01 * rows;
      const double bump = 0.3 * u * u - 0.2 * v * u + 0.05 * v;
      for (const double coordinate : {u, v, bump})
        mesh.positions.push_back(static_cast<float>(coordinate + noise * uniform()));
      for (std::uint32_t k = 0; k < 3; ++k)
        color.values.push_back(static_cast<std::byte>((x * (k + 2) + y * 3 + random() % 3) % 256));
    }
  }
  for (std::uint32_t y = 0; y < rows; ++y) {
    for (std::uint32_t x = 0; x < columns; ++x) {
      const std::uint32_t a = y * (columns + 1) + x;
      const std::uint32_t d = a + columns + 1;
      for (const std::uint32_t corner : {a, a + 1, d, a + 1, d + 1, d}) mesh.triangles.push_back(corner);
    }
  }
  mesh.attributes.push_back(std::move(color));
  return mesh;
}

/// Any faces over vertices in a cube of one unit, many of them close together.
inline Mesh random_mesh(std::uint32_t seed, std::uint32_t vertices, std::uint32_t faces) {
  std::mt19937 random(seed);
  Mesh mesh;
  for (std::uint32_t i = 0; i < 3 * vertices; ++i)
    mesh.positions.push_back(static_cast<float>(static_cast<double>(random() % 4001) / 4000 - 0.5));
  for (std::uint32_t v = 1; v < vertices; v += 3)  // close to the one before, mostly the same lattice point
    for (std::size_t k = 0; k < 3; ++k) mesh.positions[3 * v + k] = mesh.positions[3 * v - 3 + k] + 1e-5F;
  for (std::uint32_t i = 0; i < 3 * faces; ++i)
    mesh.triangles.push_back(static_cast<std::uint32_t>(random() % vertices));
  return mesh;
}

}  // namespace deltamesh::test
