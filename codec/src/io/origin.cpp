// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/origin.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "base/numbers/vec3.h"
#include "io/components.h"

namespace deltamesh {
namespace {

constexpr double kFloatMax = std::numeric_limits<float>::max();

/// Those that corners name; all where there are no corners.
std::vector<bool> counted_vertices(std::size_t vertices, std::span<const std::uint32_t> corners) {
  std::vector<bool> counted(vertices, corners.empty());
  for (const std::uint32_t v : corners) counted[v] = true;
  return counted;
}

Box finite_box(std::span<const double> coordinates, const std::vector<bool>& counted) noexcept {
  Box box = Box::empty();
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    if (!counted[i / 3] || !std::isfinite(coordinates[i])) continue;
    box.min[i % 3] = std::fmin(box.min[i % 3], coordinates[i]);
    box.max[i % 3] = std::fmax(box.max[i % 3], coordinates[i]);
  }
  return box;
}

}  // namespace

// Why nothing is lost for float32 sources: on an axis that gets an origin o, every coordinate x lies within
// half the longest side of the centre c, that is |x - c| < |c| / 8, and o is within a rounding step (or 0.5,
// where the side exceeds 2 and so |c| exceeds 8) of c. Hence o/2 <= x <= 2o, x and o are both float32 numbers
// (a whole number nearest to a float32 is one, too), and by Sterbenz's lemma x - o is a float32 number.
Mesh place_origin(std::span<const double> coordinates, std::span<const std::uint32_t> corners) {
  Mesh placed;
  const Box box = finite_box(coordinates, counted_vertices(coordinates.size() / 3, corners));
  const double side = box.longest_side();
  for (std::size_t k = 0; k < 3; ++k) {
    if (box.min[k] > box.max[k]) continue;
    const double centre = box.min[k] / 2 + box.max[k] / 2;
    if (!(std::fabs(centre) > 4 * side) || std::fabs(centre) > kFloatMax) continue;
    const double rounded = static_cast<float>(centre);
    placed.origin[k] = side > 2 ? std::round(rounded) : rounded;
  }
  placed.positions.resize(coordinates.size());
  for (std::size_t i = 0; i < coordinates.size(); ++i)
    placed.positions[i] = to_float(coordinates[i] - placed.origin[i % 3]);
  return placed;
}

void place_origin(std::span<const double> coordinates, std::span<const std::uint32_t> corners,
                  Imported& imported) {
  Mesh placed = place_origin(coordinates, corners);
  imported.mesh.origin = placed.origin;
  imported.mesh.positions = std::move(placed.positions);
  const Mesh& mesh = imported.mesh;
  const std::vector<bool> counted = counted_vertices(mesh.vertex_count(), corners);
  std::vector<float> roundings(coordinates.size());
  double& of_faces = imported.report.position_error = 0;
  double& of_others = imported.report.unused_position_error = 0;
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3) {
    Vec3 apart{};
    for (std::size_t k = 0; k < 3; ++k)
      apart[k] = coordinates[i + k] - mesh.origin[k] - static_cast<double>(mesh.positions[i + k]);
    const double distance = length(apart);
    if (!std::isfinite(distance)) continue;
    for (std::size_t k = 0; k < 3; ++k) roundings[i + k] = static_cast<float>(apart[k]);
    double& largest = counted[i / 3] ? of_faces : of_others;
    largest = std::max(largest, distance);
  }
  if (std::ranges::all_of(roundings, [](float rounding) { return rounding == 0; })) roundings.clear();
  imported.roundings = std::move(roundings);
}

}  // namespace deltamesh
