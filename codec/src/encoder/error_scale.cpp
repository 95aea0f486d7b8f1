// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "encoder/error_scale.h"

#include <algorithm>

namespace deltamesh {
namespace {

constexpr double kLargestAngle = 45;     // degrees
constexpr double kLargestUv = 1.0 / 16;  // texture coordinate units
constexpr double kLargestColor = 64;     // 255ths
constexpr double kLargestWeight = 1.0 / 8;

/// At most `largest`, unless more was asked for.
double scaled_to(double bound, double scale, double largest) noexcept {
  return std::min(bound * scale, std::max(bound, largest));
}

}  // namespace

AttributeQuality scaled(const AttributeQuality& quality, double scale) {
  AttributeQuality result = quality;
  result.normal_error = scaled_to(quality.normal_error, scale, kLargestAngle);
  if (quality.tangent_error) result.tangent_error = scaled_to(*quality.tangent_error, scale, kLargestAngle);
  result.uv_error = scaled_to(quality.uv_error, scale, kLargestUv);
  result.color_error = std::min(quality.color_error * scale + std::max(scale - 1, 0.0),
                                std::max(quality.color_error, kLargestColor));
  result.weight_error = scaled_to(quality.weight_error, scale, kLargestWeight);
  for (NamedBound& bound : result.named) bound.error *= scale;
  return result;
}

bool ScaleSearch::tell(std::uint64_t bytes) {
  constexpr double kCloseEnough = 0.99;  // of the bytes
  constexpr double kFirstStride = 3;
  const Trial now{exponent_, static_cast<double>(bytes)};
  const bool fits = now.bytes <= most_bytes_;
  (fits ? fits_ : too_large_) = now;
  done_ = (fits && (now.bytes > kCloseEnough * most_bytes_ || exponent_ <= kFinest)) ||
          (!fits && exponent_ >= kCoarsest);
  if (!fits_ || !too_large_) {
    exponent_ = std::clamp(exponent_ + (fits ? -kFirstStride : kFirstStride), kFinest, kCoarsest);
    return fits;
  }
  // On the line between both, but well inside, as bytes need not fall evenly.
  const double share = (too_large_->bytes - most_bytes_) / (too_large_->bytes - fits_->bytes);
  exponent_ =
      too_large_->exponent + std::clamp(share + 0.02, 0.1, 0.9) * (fits_->exponent - too_large_->exponent);
  return fits;
}

}  // namespace deltamesh
