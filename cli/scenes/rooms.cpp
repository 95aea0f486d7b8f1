// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// A robot's map: rooms scanned into a truncated signed distance field, its surface by marching cubes.
#include "rooms.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "field/noise.h"
#include "field/scan.h"
#include "generators.h"

namespace deltamesh::scenes {
namespace {

constexpr double kUsualVoxel = 0.05;        ///< metres
constexpr double kVerticesPerRoom = 40000;  ///< at the usual voxel size, measured
constexpr double kLargestGhost = 0.12;      ///< metres
constexpr double kVerticesPerRoomArea = kVerticesPerRoom * kUsualVoxel * kUsualVoxel;

Surface scan_building(const Building& building, double voxel, std::uint64_t seed) {
  const Lattice lattice = lattice_around(building, voxel);
  Scan scan(building, lattice, seed);
  return march_cubes(lattice, [&](std::uint32_t i) { return scan.layer(i); });
}

std::vector<std::uint8_t> color_vertices(const Building& building, std::span<const float> positions,
                                         std::uint64_t seed) {
  Random random(seed);
  std::vector<std::uint8_t> colors;
  colors.reserve(positions.size());
  for (std::size_t i = 0; i < positions.size(); i += 3) {
    const Rgb color = building.color_at({positions[i], positions[i + 1], positions[i + 2]}, seed);
    const double light = random.between(-3, 3);
    for (const std::uint8_t c : color)
      colors.push_back(static_cast<std::uint8_t>(std::clamp(c + light + random.between(-2, 2), 0.0, 255.0)));
  }
  return colors;
}

/// How far a count is from the target, as a factor of at least 1.
double mismatch(std::size_t count, double target) {
  const double ratio = (static_cast<double>(count) + 1e-3) / target;
  return std::max(ratio, 1 / ratio);
}

}  // namespace

RoomsPlan plan_rooms(std::uint64_t vertices) {
  const auto wanted = static_cast<double>(vertices);
  const auto rooms = static_cast<std::uint32_t>(std::max(1.0, std::floor(wanted / kVerticesPerRoom + 0.5)));
  return {rooms, round_voxel(std::sqrt(kVerticesPerRoomArea * rooms / wanted))};
}

double round_voxel(double voxel) { return std::floor(voxel * 1e4 + 0.5) / 1e4; }

Building make_building(const RoomsPlan& plan, std::uint64_t seed) {
  return Building(plan.rooms, std::min(2 * plan.voxel, kLargestGhost), seed);
}

Lattice lattice_around(const Building& building, double voxel) {
  Lattice lattice;
  lattice.voxel = voxel;
  lattice.base = -2.37 * voxel * Point{1, 1, 1};  // off the walls' planes
  const Point size = building.size();
  const double sizes[] = {size.x, size.y, size.z};
  for (std::size_t axis = 0; axis < 3; ++axis)
    lattice.nodes[axis] = static_cast<std::uint32_t>(std::ceil(sizes[axis] / voxel)) + 6;
  return lattice;
}

Mesh make_rooms(std::uint64_t target, std::uint64_t seed) {
  constexpr int kTries = 8;
  constexpr double kGoodEnough = 1.05;
  Random random(seed);
  const std::uint64_t building_seed = random.bits();
  const std::uint64_t noise_seed = random.bits();
  const RoomsPlan plan = plan_rooms(target);
  const Building building = make_building(plan, building_seed);
  const auto wanted = static_cast<double>(target);
  double voxel = plan.voxel;
  Surface best;
  for (int i = 0; i < kTries; ++i) {
    Surface surface = scan_building(building, voxel, noise_seed);
    const std::size_t count = surface.positions.size() / 3;
    const double factor = std::sqrt(static_cast<double>(std::max<std::size_t>(count, 1)) / wanted);
    voxel = round_voxel(voxel * std::clamp(factor, 0.5, 2.0));
    const bool is_better = mismatch(count, wanted) < mismatch(best.positions.size() / 3, wanted);
    if (is_better) best = std::move(surface);
    if (mismatch(count, wanted) < kGoodEnough) break;
  }
  Mesh mesh;
  mesh.positions = std::move(best.positions);
  mesh.triangles = std::move(best.triangles);
  const auto colors = color_vertices(building, mesh.positions, noise_seed);
  add_attribute<std::uint8_t>(mesh, AttributeKind::kColor, ComponentType::kU8, 3, "red", colors);
  return mesh;
}

}  // namespace deltamesh::scenes
