// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "encoder/scaled_quality.h"

#include <algorithm>

namespace deltamesh {
namespace {

constexpr double kLargestAngle = 45;     // degrees
constexpr double kLargestUv = 1.0 / 16;  // texture coordinate units
constexpr double kLargestColor = 64;     // 255ths
constexpr double kLargestColorRms = 32;  // 255ths
constexpr double kLargestWeight = 1.0 / 8;

/// At most `largest`, unless more was asked for.
double scaled_to(double bound, double scale, double largest) noexcept {
  return std::min(bound * scale, std::max(bound, largest));
}

}  // namespace

AttributeQuality scaled(const AttributeQuality& quality, double scale) {
  if (quality.is_asked) scale = std::min(scale, 1.0);
  AttributeQuality result = quality;
  result.normal_error = scaled_to(quality.normal_error, scale, kLargestAngle);
  if (quality.tangent_error) result.tangent_error = scaled_to(*quality.tangent_error, scale, kLargestAngle);
  result.uv_error = scaled_to(quality.uv_error, scale, kLargestUv);
  if (quality.color_rms) result.color_rms = scaled_to(*quality.color_rms, scale, kLargestColorRms);
  if (quality.color_error) result.color_error = scaled_to(*quality.color_error, scale, kLargestColor);
  result.weight_error = scaled_to(quality.weight_error, scale, kLargestWeight);
  for (NamedBound& bound : result.named) bound.error *= scale;
  return result;
}

}  // namespace deltamesh
