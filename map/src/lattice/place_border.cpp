// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "lattice/place_border.h"

#include <cstddef>
#include <cstdint>

#include "base/numbers/vec3.h"
#include "topology/weld.h"

namespace deltamesh {
namespace {

constexpr int kSweeps = 16;  // [MAP-20]

/// The way of every position, by its number in `weld`: of border vertices to their points, of others the mean
/// of their neighbours' ways, as far as the sweeps come. Sums in the order of faces and corners.
std::vector<Vec3> ways_of(const Mesh& mesh, const Weld& weld, std::span<const BorderVertex> border,
                          const MapLattice& lattice) {
  const std::size_t count = weld.representative.size();
  std::vector<Vec3> ways(count);
  std::vector<std::uint8_t> is_fixed(count, 0);
  for (const BorderVertex& vertex : border) {
    const std::uint32_t v = weld.geometric[vertex.vertex];
    const auto position = lattice.position_of(vertex.point);
    is_fixed[v] = 1;
    for (std::size_t k = 0; k < 3; ++k)
      ways[v][k] = double{position[k]} - double{mesh.positions[3 * std::size_t{vertex.vertex} + k]};
  }
  std::vector<double> weights(count, 0);
  std::vector<Vec3> sums(count);
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    sums.assign(count, Vec3{});
    for (std::size_t f = 0; f < mesh.triangles.size(); f += 3) {
      for (std::size_t c = 0; c < 3; ++c) {
        const std::uint32_t a = weld.geometric[mesh.triangles[f + c]];
        const std::uint32_t b = weld.geometric[mesh.triangles[f + (c + 1) % 3]];
        sums[a] = sums[a] + ways[b];
        sums[b] = sums[b] + ways[a];
        if (sweep > 0) continue;
        weights[a] += 1;
        weights[b] += 1;
      }
    }
    for (std::size_t v = 0; v < count; ++v)
      for (std::size_t k = 0; k < 3 && is_fixed[v] == 0; ++k)
        ways[v][k] = weights[v] > 0 ? sums[v][k] / weights[v] : 0;
  }
  return ways;
}

}  // namespace

std::vector<float> positions_of(const Mesh& mesh, std::span<const BorderVertex> border) {
  std::vector<float> positions;
  positions.reserve(3 * border.size());
  for (const BorderVertex& vertex : border)
    for (std::size_t k = 0; k < 3; ++k)
      positions.push_back(mesh.positions[3 * std::size_t{vertex.vertex} + k]);
  return positions;
}

std::vector<float> streamed_positions(const MapPart& part) {
  std::vector<float> positions = part.mesh.positions;
  for (std::size_t i = 0; i < part.streamed_border.size(); ++i)
    positions[3 * std::size_t{part.border[i / 3].vertex} + i % 3] = part.streamed_border[i];
  return positions;
}

void place_border(Mesh& mesh, std::span<const BorderVertex> border, const MapLattice& lattice, bool spreads) {
  if (spreads && !border.empty()) {
    const std::vector<std::uint8_t> all(mesh.vertex_count(), 1);
    const Weld weld = weld_by_position(mesh.positions, all);
    const std::vector<Vec3> ways = ways_of(mesh, weld, border, lattice);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
      mesh.positions[i] = static_cast<float>(double{mesh.positions[i]} + ways[weld.geometric[i / 3]][i % 3]);
  }
  for (const BorderVertex& vertex : border) {
    const auto position = lattice.position_of(vertex.point);
    for (std::size_t k = 0; k < 3; ++k) mesh.positions[3 * std::size_t{vertex.vertex} + k] = position[k];
  }
}

}  // namespace deltamesh
