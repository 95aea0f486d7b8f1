// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "grid/source/fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/memory/large_vector.h"
#include "positions/lattice/value_planes.h"
#include "positions/rounding.h"

namespace deltamesh {
namespace {

constexpr double kFewestOnEdges = 0.2;
constexpr std::size_t kFewestEqual = 4;  ///< coordinates that make a plane of voxels

/// Whether most planes that are a few distances apart are whole distances apart.
bool makes_comb(std::span<const Plane> planes, double distance) noexcept {
  constexpr double kFew = 6.5;
  constexpr double kOff = 0.1;
  std::size_t near = 0;
  std::size_t whole = 0;
  for (std::size_t i = 1; i < planes.size(); ++i) {
    const double turns = (planes[i].place - planes[i - 1].place) / distance;
    if (turns > kFew) continue;
    ++near;
    whole += std::abs(turns - nearest(turns)) < kOff && turns > 0.5 ? 1 : 0;
  }
  return 5 * whole > 2 * near;
}

/// Where in [0, 1) of a distance most coordinates on planes are.
double usual_phase(std::span<const Plane> planes, double distance) {
  constexpr std::size_t kBins = 64;
  std::array<double, kBins> weight{};
  const auto phase = [&](const Plane& plane) {
    const double turns = (plane.place - planes[0].place) / distance;
    return turns - std::floor(turns);
  };
  for (const Plane& plane : planes) {
    const auto bin = static_cast<std::size_t>(phase(plane) * kBins) % kBins;
    for (const std::size_t near : {bin + kBins - 1, bin, bin + 1})
      weight[near % kBins] += static_cast<double>(plane.count);
  }
  const auto best = std::max_element(weight.begin(), weight.end()) - weight.begin();
  return (static_cast<double>(best) + 0.5) / kBins;
}

struct Placement {
  unsigned on_planes = 0;
  std::size_t free_axis = 0;
  Vec3 turns{};  ///< place in voxels
};

/// The axis that is farthest from its planes is the free one.
Placement place_vertex(const Vec3& position, const VoxelFit& fit) noexcept {
  Placement placement;
  double farthest = -1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double turns = (position[axis] - fit.origin[axis]) / fit.voxel[axis];
    const double off = std::abs(turns - nearest(turns)) * fit.voxel[axis];
    placement.turns[axis] = turns;
    placement.on_planes += off <= fit.noise ? 1 : 0;
    placement.free_axis = off > farthest ? axis : placement.free_axis;
    farthest = std::max(farthest, off);
  }
  return placement;
}

/// How far a coordinate may be from its true place: a few roundings of the largest one to float.
double rounding_noise(const Box& box) noexcept {
  double reach = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    reach = std::max({reach, std::abs(box.min[axis]), std::abs(box.max[axis])});
  return reach * 0x1p-21;
}

/// `fit` with its share; empty where that is too small.
std::optional<VoxelFit> with_share(VoxelFit fit, const AxisValues& values) {
  const std::span<const Vec3> positions = values.positions();
  std::array<std::size_t, 3> along{};  // vertices inside an edge of each axis
  std::size_t sampled = 0;
  for (std::size_t v = 0; v < positions.size(); v += values.stride(), ++sampled) {
    const Placement placement = place_vertex(positions[v], fit);
    if (placement.on_planes == 2) ++along[placement.free_axis];
  }
  const std::size_t inside = along[0] + along[1] + along[2];
  fit.share = static_cast<double>(inside) / static_cast<double>(sampled);
  if (fit.share < kFewestOnEdges) return std::nullopt;
  const std::size_t largest = *std::max_element(along.begin(), along.end());
  fit.along_one_axis = static_cast<double>(largest) / static_cast<double>(inside);
  return fit;
}

/// With cubes of twice the size; of the eight such grids the one on whose planes most coordinates lie.
VoxelFit twice_as_large(const VoxelFit& fit, const AxisValues& values) {
  std::array<std::array<std::size_t, 2>, 3> on_planes{};
  const std::span<const Vec3> positions = values.positions();
  for (std::size_t v = 0; v < positions.size(); v += values.stride()) {
    const Placement placement = place_vertex(positions[v], fit);
    if (placement.on_planes < 2) continue;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (axis != placement.free_axis)
        ++on_planes[axis][static_cast<std::size_t>(std::abs(nearest(placement.turns[axis]))) % 2];
  }
  VoxelFit large = fit;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (on_planes[axis][1] > on_planes[axis][0]) large.origin[axis] -= fit.voxel[axis];
    large.voxel[axis] = 2 * fit.voxel[axis];
  }
  return large;
}

/// Whether a cube of `fit` has these corners of a face on its edges.
bool is_in_cube(const VoxelFit& fit, const std::array<Vec3, 3>& corners) noexcept {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Vec3 least = {kInfinity, kInfinity, kInfinity};
  Vec3 most = {-kInfinity, -kInfinity, -kInfinity};
  for (const Vec3& corner : corners) {
    const Placement placement = place_vertex(corner, fit);
    if (placement.on_planes < 2) return false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool is_on_plane = axis != placement.free_axis;
      const double turns = is_on_plane ? nearest(placement.turns[axis]) : placement.turns[axis];
      least[axis] = std::min(least[axis], turns);
      most[axis] = std::max(most[axis], turns);
    }
  }
  bool is_inside = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
    is_inside = is_inside && std::ceil(most[axis]) - 1 <= std::floor(least[axis]);
  return is_inside;
}

double share_in_cubes(const VoxelFit& fit, std::span<const Vec3> positions,
                      std::span<const std::uint32_t> triangles) noexcept {
  constexpr std::size_t kSampled = 2048;
  const std::size_t faces = triangles.size() / 3;
  std::size_t seen = 0;
  std::size_t inside = 0;
  for (std::size_t f = 0; f < faces; f += 1 + faces / kSampled, ++seen) {
    const auto at = [&](std::size_t c) { return positions[triangles[3 * f + c]]; };
    inside += is_in_cube(fit, {at(0), at(1), at(2)}) ? 1 : 0;
  }
  return seen > 0 ? static_cast<double>(inside) / static_cast<double>(seen) : 0;
}

}  // namespace

std::optional<VoxelFit> fit_to_grid(const VoxelGrid& grid, const AxisValues& values, const Box& box) {
  if (values.positions().empty()) return std::nullopt;
  const double noise = 2 * rounding_noise(box) + 1e-4 * std::min({grid.edge[0], grid.edge[1], grid.edge[2]});
  const VoxelFit fit{.origin = grid.origin, .voxel = grid.edge, .noise = noise, .is_given = true};
  return with_share(fit, values);
}

std::optional<VoxelFit> fit_voxels(const AxisValues& values, const Box& box) {
  const std::span<const Vec3> positions = values.positions();
  if (positions.size() < 64) return std::nullopt;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!values.has_repeats(axis)) return std::nullopt;
  const double noise = rounding_noise(box);

  std::array<std::vector<Plane>, 3> planes;
  double distance = 0;
  std::size_t most = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    planes[axis] = find_planes(values, axis, noise, kFewestEqual);
    const double found = usual_distance(planes[axis]);
    if (found > 0 && makes_comb(planes[axis], found) && planes[axis].size() > most) {
      most = planes[axis].size();
      distance = found;
    }
  }
  if (!(distance > 16 * noise)) return std::nullopt;

  VoxelFit fit{.noise = 2 * noise + 1e-4 * distance};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (planes[axis].empty()) return std::nullopt;
    const double own = usual_distance(planes[axis]);
    PlaneComb comb{0, std::abs(own - distance) < 0.01 * distance ? own : distance};
    comb.origin = planes[axis][0].place + usual_phase(planes[axis], comb.distance) * comb.distance;
    for (const double tolerance : {0.05, 0.01, 0.002}) comb = refine(planes[axis], comb, tolerance);
    if (!(comb.distance > 0.5 * distance && comb.distance < 2 * distance)) return std::nullopt;
    fit.voxel[axis] = comb.distance;
    // A whole node below the smallest coordinate, noise and all.
    fit.origin[axis] =
        comb.origin + comb.distance * (std::floor((box.min[axis] - comb.origin) / comb.distance) - 1);
  }
  return with_share(fit, values);
}

VoxelFit for_most_faces(const VoxelFit& fit, const AxisValues& values,
                        std::span<const std::uint32_t> triangles) {
  VoxelFit usual = fit;
  usual.in_cubes = share_in_cubes(fit, values.positions(), triangles);
  if (fit.is_given) return usual;
  VoxelFit large = twice_as_large(fit, values);
  large.in_cubes = share_in_cubes(large, values.positions(), triangles);
  return large.in_cubes > usual.in_cubes ? large : usual;
}

std::optional<VoxelCells> to_voxel_cells(std::span<const Vec3> positions, const Box& box, const VoxelFit& fit,
                                         std::uint32_t levels) {
  const double voxel = 2.0 * levels;
  VoxelCells result{.lattice = {.origin = fit.origin}, .cells = {}};
  reserve_large(result.cells, positions.size());
  result.cells.resize(positions.size());
  Vec3 firsts{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.lattice.step[axis] = fit.voxel[axis] / voxel;
    // A mesh on a given grid starts at its own first node.
    const double before =
        fit.is_given ? std::floor((box.min[axis] - fit.noise - fit.origin[axis]) / fit.voxel[axis]) : 0;
    const double nodes = std::ceil((box.max[axis] - fit.origin[axis]) / fit.voxel[axis]) + 1 - before;
    if (nodes * voxel > kMostCells || std::abs(before * voxel) > static_cast<double>(kMostFirst))
      return std::nullopt;
    firsts[axis] = before * voxel;
    result.lattice.first[axis] = static_cast<std::int64_t>(firsts[axis]);
    result.lattice.cells[axis] = static_cast<std::uint32_t>(nodes * voxel);
  }
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const Placement placement = place_vertex(positions[v], fit);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double turns = placement.turns[axis];
      double q = nearest(turns * voxel);
      if (placement.on_planes >= 2)
        q = axis == placement.free_axis ? 2 * floor_of(turns * levels) + 1 : voxel * nearest(turns);
      result.cells[v][axis] = static_cast<std::int32_t>(q - firsts[axis]);
    }
  }
  return result;
}

}  // namespace deltamesh
