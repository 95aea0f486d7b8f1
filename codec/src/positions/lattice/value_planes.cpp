// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "positions/lattice/value_planes.h"

#include <algorithm>
#include <cmath>

#include "positions/rounding.h"

namespace deltamesh {
namespace {

constexpr std::size_t kFewestPlanes = 5;

}  // namespace

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

double usual_distance(std::span<const Plane> planes, double share) {
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

PlaneComb refine(std::span<const Plane> planes, const PlaneComb& comb, double tolerance) {
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

}  // namespace deltamesh
