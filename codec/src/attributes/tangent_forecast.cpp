// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/tangent_forecast.h"

#include <algorithm>
#include <cmath>

namespace deltamesh {
namespace {

constexpr double kFarthest = 1.5;  ///< differences beyond are not used
constexpr double kLeastSquare = 1e-12;

/// A unit vector orthogonal to `pole`, near `wish` where that is possible.
Vec3 orthogonal_to(const Vec3& pole, const Vec3& wish) noexcept {
  Vec3 first = wish - dot(pole, wish) * pole;
  if (dot(first, first) > 1e-6 && normalize(first) > 0) return first;
  const Vec3 axis = std::fabs(pole[0]) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  first = axis - dot(pole, axis) * pole;
  normalize(first);
  return first;
}

TwoDoubles pair_at(const NormalFrame& frame, const Vec3& direction) noexcept {
  const auto x = point_of(frame, direction);
  return TwoDoubles{x[0], x[1]};
}

}  // namespace

TangentForecaster::TangentForecaster(const AttributeSurface& surface, const SurfaceWalk& walk,
                                     std::span<const float> normals, std::span<const float> uvs)
    : surface_(surface), walk_(walk), rule_(surface, normals, uvs), known_(surface.vertex_count()) {}

TangentForecast TangentForecaster::forecast(std::size_t i) {
  const std::uint32_t vertex = walk_.order[i];
  const RuledTangent ruled = rule_.at(vertex);
  const auto triangles = surface_.triangles();
  const auto faces = walk_.completed_by(i);
  TwoDoubles off{};
  double ruled_count = 0;
  Vec3 sum{};
  for (const std::uint32_t corner : faces) {
    for (const std::uint32_t other : {triangles[next_corner(corner)], triangles[corner_before(corner)]}) {
      const Known& known = known_[other];
      sum = sum + known.tangent;
      if (!known.has_rule) continue;
      off += known.off;
      ruled_count += 1;
    }
  }
  if (faces.empty() && i > 0) sum = known_[walk_.order[i - 1]].tangent;
  const bool has_mean = normalize(sum) > 0;
  const bool has_rule = dot(ruled.direction, ruled.direction) > 0;

  TangentForecast result;
  result.is_mirrored = ruled.area < 0;
  if (has_rule) {
    source_ = faces.empty() ? TangentSource::kRule
                            : (faces.size() == 1 ? TangentSource::kRuleAndOne : TangentSource::kRuleAndMore);
    frame_.pole = ruled.direction;
  } else {
    source_ = has_mean ? TangentSource::kNeighbors : TangentSource::kNothing;
    frame_.pole = has_mean ? sum : Vec3{1, 0, 0};
  }
  frame_.second = orthogonal_to(frame_.pole, ruled.normal);
  frame_.first = cross(frame_.second, frame_.pole);
  differences_ = {};
  if (has_rule) {
    const ForecastDifferences all = {ruled_count > 0 ? off / ruled_count : TwoDoubles{},
                                     pair_at(frame_, ruled.by_area)};
    for (std::size_t k = 0; k < 2; ++k)
      if (dot(all[k], all[k]) <= kFarthest * kFarthest) differences_[k] = all[k];
  }
  result.frame = frame_;
  result.source = source_;
  result.center = blends_[static_cast<std::size_t>(source_)].correction(differences_);
  if (!(dot(result.center, result.center) <= 1)) result.center = TwoDoubles{};
  if (has_rule) {
    for (std::size_t k = 0; k < 2; ++k)
      result.spread[k] = 0.5 * std::fabs(differences_[0][k] - result.center[k]);
    result.spread[0] += 0.25 * ruled.dispersion;
  }
  return result;
}

void TangentForecaster::settle(std::size_t i, const Vec3& tangent) {
  Known& known = known_[walk_.order[i]];
  known.tangent = tangent;
  known.has_rule = source_ >= TangentSource::kRule;
  known.off = pair_at(frame_, tangent);
  if (!(dot(known.off, known.off) <= kFarthest * kFarthest)) known.has_rule = false;
  if (!known.has_rule) return;
  double squares = kLeastSquare + dot(known.off, known.off);
  for (const TwoDoubles& d : differences_) squares += dot(d, d);
  blends_[static_cast<std::size_t>(source_)].learn(differences_, known.off, 1 / squares);
}

}  // namespace deltamesh
