// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/tangents/prediction.h"

#include <cmath>

namespace deltamesh {
namespace {

constexpr float kFarthestUv = 2.25F;  ///< squared distances beyond are not used
constexpr float kLeastUvSquare = 1e-12F;

float square_of(PlanePoint x) noexcept { return x[0] * x[0] + x[1] * x[1]; }

/// The point of a direction; of the half around the pole's opposite, too far off.
PlanePoint place_of(const NormalFrame& frame, FourFloats direction) noexcept {
  const float inverse = 1 / (1 + std::fmax(dot3(frame.pole, direction), -0.5F));
  return {dot3(frame.first, direction) * inverse, dot3(frame.second, direction) * inverse};
}

}  // namespace

TangentPredictor::TangentPredictor(const AttributeSurface& surface, const SurfaceOrder& order,
                                   std::span<const float> normals, std::span<const float> uvs)
    : order_(order), rule_(surface, normals, uvs), known_(surface.vertex_count()) {}

TangentPrediction TangentPredictor::prediction(std::size_t i) {
  const RuledTangent ruled = rule_.at(order_.vertices[i]);
  const auto faces = order_.completed_by(i);
  Known sum;
  for (const Corner& corner : faces) {
    for (const std::uint32_t other : {corner.next, corner.before}) {
      sum.tangent += known_[other].tangent;
      sum.off += known_[other].off;
    }
  }
  if (faces.empty() && i > 0) sum.tangent = known_[order_.vertices[i - 1]].tangent;

  TangentPrediction result;
  result.is_mirrored = ruled.area < 0;
  FourFloats pole{1, 0, 0, 0};
  const float square = dot3(ruled.direction, ruled.direction);
  if (square > kLeastUvSquare && square < 1 / kLeastUvSquare) {
    source_ = faces.empty() ? TangentSource::kRule
                            : (faces.size() == 1 ? TangentSource::kRuleAndOne : TangentSource::kRuleAndMore);
    pole = ruled.direction;
  } else if (dot3(sum.tangent, sum.tangent) > kLeastUvSquare) {
    source_ = TangentSource::kNeighbors;
    pole = sum.tangent;
  } else {
    source_ = TangentSource::kNothing;
  }
  const NormalFrame turned = make_frame(pole, ruled.normal);
  frame_ = {.pole = turned.pole, .first = turned.second, .second = turned.first};
  mean_ = {};
  result.frame = frame_;
  result.source = source_;
  if (source_ < TangentSource::kRule) return result;
  if (sum.off[2] > 0) mean_ = {sum.off[0] / sum.off[2], sum.off[1] / sum.off[2]};
  const float share = shares_[static_cast<std::size_t>(source_)].value();
  result.center = {share * mean_[0], share * mean_[1]};
  if (!(square_of(result.center) <= 1)) result.center = {};
  for (std::size_t k = 0; k < 2; ++k) result.spread[k] = 0.5F * std::fabs(mean_[k] - result.center[k]);
  result.spread[0] += 0.25F * ruled.dispersion;
  return result;
}

void TangentPredictor::settle(std::size_t i, FourFloats tangent) {
  Known& known = known_[order_.vertices[i]];
  known.tangent = tangent;
  if (source_ < TangentSource::kRule) return;
  const PlanePoint off = place_of(frame_, tangent);
  const float square = square_of(off);
  if (!(square <= kFarthestUv)) return;
  known.off = FourFloats{off[0], off[1], 1, 0};
  shares_[static_cast<std::size_t>(source_)].learn(mean_, off,
                                                   1 / (kLeastUvSquare + square + square_of(mean_)));
}

}  // namespace deltamesh
