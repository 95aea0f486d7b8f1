// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "quality/normal_angles.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "quality/vertex_normals.h"

namespace deltamesh {

void NormalAngles::add(const Vec3& a, const Vec3& b) {
  if (a != Vec3{} && b != Vec3{}) degrees_.push_back(angle_degrees(a, b));
}

void NormalAngles::report(Comparison& result) {
  if (degrees_.empty()) return;
  const auto count = static_cast<double>(degrees_.size());
  result.normal_angle_mean = std::accumulate(degrees_.begin(), degrees_.end(), 0.0) / count;
  const auto rank = static_cast<std::ptrdiff_t>(std::ceil(0.95 * count)) - 1;
  std::nth_element(degrees_.begin(), degrees_.begin() + rank, degrees_.end());
  result.normal_angle_p95 = degrees_[static_cast<std::size_t>(rank)];
}

}  // namespace deltamesh
