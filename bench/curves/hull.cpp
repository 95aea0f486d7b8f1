// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "curves/hull.h"

#include <algorithm>
#include <cmath>

namespace deltamesh::bench {
namespace {

bool is_positive(double x) { return std::isfinite(x) && x > 0; }

/// Above 0 where `c` lies above the line from `a` to `b`; a.error < b.error < c.error.
double turn(const CurvePoint& a, const CurvePoint& b, const CurvePoint& c) {
  return std::log(b.error / a.error) * (c.bytes - a.bytes) -
         (b.bytes - a.bytes) * std::log(c.error / a.error);
}

}  // namespace

std::vector<CurvePoint> lower_hull(std::span<const CurvePoint> points) {
  std::vector<CurvePoint> sorted;
  for (const CurvePoint& point : points)
    if (is_positive(point.error) && is_positive(point.bytes)) sorted.push_back(point);
  std::sort(sorted.begin(), sorted.end(), [](const CurvePoint& a, const CurvePoint& b) {
    return a.error != b.error ? a.error < b.error : a.bytes < b.bytes;
  });
  std::vector<CurvePoint> hull;
  for (const CurvePoint& point : sorted) {
    if (!hull.empty() && point.bytes >= hull.back().bytes) continue;  // dominated
    while (hull.size() >= 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0) hull.pop_back();
    hull.push_back(point);
  }
  return hull;
}

std::optional<double> bytes_at(std::span<const CurvePoint> hull, double error) {
  if (hull.empty() || error < hull.front().error) return std::nullopt;
  if (error >= hull.back().error) return hull.back().bytes;
  const auto right = std::upper_bound(hull.begin(), hull.end(), error,
                                      [](double e, const CurvePoint& point) { return e < point.error; });
  const auto left = right - 1;
  const double share = std::log(error / left->error) / std::log(right->error / left->error);
  return left->bytes + share * (right->bytes - left->bytes);
}

}  // namespace deltamesh::bench
