// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "predictive/voxel_fit.h"

#include <algorithm>
#include <cmath>

#include "base/large_vector.h"
#include "predictive/lattice.h"
#include "predictive/rounding.h"

namespace deltamesh {
namespace {

constexpr double kFewestOnEdges = 0.2;
constexpr double kMostAlongOneAxis = 0.9;
constexpr std::size_t kFewestPlanes = 5;
constexpr std::size_t kFewestEqual = 4;  ///< coordinates that make a plane of voxels

/// A value that many coordinates of an axis share but for rounding.
struct Plane {
  double place;
  std::size_t count;
};

/// `fewest`: coordinates that make a plane.
std::vector<Plane> find_planes(const AxisValues& coordinates, std::size_t axis, double noise,
                               std::size_t fewest) {
  if (!coordinates.has_repeats(axis)) return {};
  const std::span<const float> sorted = coordinates.sorted(axis);
  // Values that come up again and again to the last bit, and then those next to each other.
  std::vector<Plane> values;
  std::size_t most = 0;
  for (std::size_t begin = 0, end = 0; begin < sorted.size(); begin = end) {
    while (end < sorted.size() && sorted[end] == sorted[begin]) ++end;
    if (end - begin >= fewest) values.push_back({sorted[begin], end - begin});
    most = std::max(most, end - begin);
  }
  if (fewest > 1) std::erase_if(values, [most](const Plane& value) { return value.count < most / 50; });
  std::vector<Plane> planes;
  for (const Plane& value : values) {
    if (planes.empty() || value.place - planes.back().place > noise) {
      planes.push_back(value);
      continue;
    }
    Plane& plane = planes.back();
    plane.count += value.count;
    plane.place +=
        (value.place - plane.place) * static_cast<double>(value.count) / static_cast<double>(plane.count);
  }
  return planes;
}

/// The distance of neighbouring planes that `share` of them are below, made sharper by the mean of those near
/// it; 0 where there are too few planes.
double usual_distance(std::span<const Plane> planes, double share = 0.5) {
  if (planes.size() < kFewestPlanes) return 0;
  std::vector<double> distances;
  for (std::size_t i = 1; i < planes.size(); ++i) distances.push_back(planes[i].place - planes[i - 1].place);
  const auto middle =
      distances.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(distances.size()));
  std::nth_element(distances.begin(), middle, distances.end());
  const double median = *middle;
  double sum = 0;
  std::size_t count = 0;
  for (const double distance : distances) {
    if (std::abs(distance - median) > 0.02 * median) continue;
    sum += distance;
    ++count;
  }
  return sum / static_cast<double>(count);
}

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

struct Comb {
  double origin;
  double distance;
};

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

/// Least squares of the planes that the comb meets within `tolerance` of its distance.
Comb refine(std::span<const Plane> planes, const Comb& comb, double tolerance) {
  double count = 0;
  double sum_i = 0;
  double sum_ii = 0;
  double sum_p = 0;
  double sum_ip = 0;
  for (const Plane& plane : planes) {
    const double turns = (plane.place - comb.origin) / comb.distance;
    const double index = nearest(turns);
    if (std::abs(turns - index) > tolerance) continue;
    const double place = plane.place - comb.origin;
    count += 1;
    sum_i += index;
    sum_ii += index * index;
    sum_p += place;
    sum_ip += index * place;
  }
  const double determinant = count * sum_ii - sum_i * sum_i;
  if (!(count >= 3 && determinant > 0)) return comb;
  const double distance = (count * sum_ip - sum_i * sum_p) / determinant;
  return {comb.origin + (sum_p - distance * sum_i) / count, distance};
}

double off_comb(double x, double origin, double distance) noexcept {
  const double turns = (x - origin) / distance;
  return std::abs(turns - nearest(turns)) * distance;
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

}  // namespace

std::optional<VoxelFit> fit_voxels(const AxisValues& values, const Box& box) {
  const std::span<const Vec3> positions = values.positions();
  if (positions.size() < 64) return std::nullopt;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!values.has_repeats(axis)) return std::nullopt;
  double reach = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    reach = std::max({reach, std::abs(box.min[axis]), std::abs(box.max[axis])});
  const double noise = reach * 0x1p-21;  // a few roundings of the largest coordinate to float

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
    Comb comb{0, std::abs(own - distance) < 0.01 * distance ? own : distance};
    comb.origin = planes[axis][0].place + usual_phase(planes[axis], comb.distance) * comb.distance;
    for (const double tolerance : {0.05, 0.01, 0.002}) comb = refine(planes[axis], comb, tolerance);
    if (!(comb.distance > 0.5 * distance && comb.distance < 2 * distance)) return std::nullopt;
    fit.voxel[axis] = comb.distance;
    // A whole node below the smallest coordinate, noise and all.
    fit.origin[axis] =
        comb.origin + comb.distance * (std::floor((box.min[axis] - comb.origin) / comb.distance) - 1);
  }
  std::array<std::size_t, 3> along{};  // vertices inside an edge of each axis
  std::size_t sampled = 0;
  for (std::size_t v = 0; v < positions.size(); v += values.stride(), ++sampled) {
    const Placement placement = place_vertex(positions[v], fit);
    if (placement.on_planes == 2) ++along[placement.free_axis];
  }
  const std::size_t inside = along[0] + along[1] + along[2];
  fit.share = static_cast<double>(inside) / static_cast<double>(sampled);
  if (fit.share < kFewestOnEdges) return std::nullopt;
  // Heights over a grid, say: a lattice of their own suits them better.
  const std::size_t largest = *std::max_element(along.begin(), along.end());
  if (static_cast<double>(largest) > kMostAlongOneAxis * static_cast<double>(inside)) return std::nullopt;
  return fit;
}

std::array<AxisGrid, 3> fit_axes(const AxisValues& values, const Box& box, double finest) {
  const std::span<const Vec3> positions = values.positions();
  constexpr double kFinestShare = 0.1;
  constexpr double kOff = 0.05;  // sources are rounded, to decimals say
  constexpr std::size_t kMostBetween = 8;
  std::array<AxisGrid, 3> grids{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double noise = std::max(std::abs(box.min[axis]), std::abs(box.max[axis])) * 0x1p-22;
    if (values.count_distances(axis, 2 * noise, finest / 2) > kMostBetween) continue;
    const std::vector<Plane> planes = find_planes(values, axis, noise, 1);
    Comb comb{0, usual_distance(planes, kFinestShare)};
    if (!(comb.distance > std::max(8 * noise, finest))) continue;
    comb.origin = planes[0].place;
    for (const double tolerance : {0.1, 0.05, 0.02}) comb = refine(planes, comb, tolerance);
    const bool all = std::all_of(positions.begin(), positions.end(), [&](const Vec3& position) {
      return off_comb(position[axis], comb.origin, comb.distance) <= 2 * noise + kOff * comb.distance;
    });
    if (!all) continue;
    const double below = std::round((box.min[axis] - comb.origin) / comb.distance);
    const double origin = comb.origin + comb.distance * below;
    grids[axis] = {std::abs(origin - box.min[axis]) <= noise ? box.min[axis] : origin, comb.distance};
  }
  return grids;
}

PositionLattice grid_lattice(const Box& box, const std::array<AxisGrid, 3>& axes, double step) noexcept {
  constexpr double kNotMuchFiner = 0.6;
  PositionLattice lattice = cubic_lattice(box, step);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const AxisGrid& grid = axes[axis];
    if (!(grid.step > kNotMuchFiner * lattice.step[axis])) continue;
    const double cells = std::round((box.max[axis] - grid.origin) / grid.step);
    if (!(cells <= kMostCells)) continue;
    lattice.origin[axis] = grid.origin;
    lattice.first[axis] = 0;
    lattice.step[axis] = grid.step;
    lattice.cells[axis] = static_cast<std::uint32_t>(cells);
  }
  return lattice;
}

std::optional<VoxelCells> to_voxel_cells(std::span<const Vec3> positions, const Box& box, const VoxelFit& fit,
                                         std::uint32_t levels) {
  const double voxel = 2.0 * levels;
  VoxelCells result{.lattice = {.origin = fit.origin}, .cells = {}};
  reserve_large(result.cells, positions.size());
  result.cells.resize(positions.size());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.lattice.step[axis] = fit.voxel[axis] / voxel;
    const double nodes = std::ceil((box.max[axis] - fit.origin[axis]) / fit.voxel[axis]) + 1;
    if (nodes * voxel > kMostCells) return std::nullopt;
    result.lattice.cells[axis] = static_cast<std::uint32_t>(nodes * voxel);
  }
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const Placement placement = place_vertex(positions[v], fit);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double turns = placement.turns[axis];
      double q = nearest(turns * voxel);
      if (placement.on_planes >= 2)
        q = axis == placement.free_axis ? 2 * floor_of(turns * levels) + 1 : voxel * nearest(turns);
      result.cells[v][axis] = static_cast<std::int32_t>(q);
    }
  }
  return result;
}

}  // namespace deltamesh
