// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <cmath>
#include <limits>

#include "base/try.h"
#include "deltamesh/encode.h"
#include "format/highpass_parameters.h"
#include "search/request.h"

namespace deltamesh {
namespace {

Error invalid_option(const char* message) noexcept {
  return {.code = ErrorCode::kInvalidArgument, .message = message};
}

bool within(int value, int least, int most) noexcept { return value >= least && value <= most; }

/// What the request would set is not set by hand.
Result<void> check_quality(const EncodeOptions& o) noexcept {
  const QualityRequest& q = o.quality;
  DELTAMESH_CHECK(validate(q));
  if ((q.vde || q.max_error || q.target_bytes) && (o.bits || o.step))
    return invalid_option("VDE, maximum error and target bytes set the step: bits and step exclude them");
  if ((q.lfe || q.max_error) && (o.anchors || o.anchor_density))
    return invalid_option("LFE and maximum error set the anchors: anchors and anchor density exclude them");
  return {};
}

/// Bits, step and anchors by hand.
Result<void> check_steps(const EncodeOptions& o) noexcept {
  const bool predictive = o.geometry == GeometryCoder::kPredictive;
  if (o.bits && o.step) return invalid_option("bits and step exclude each other");
  if (o.bits && predictive && !within(*o.bits, 1, 28)) return invalid_option("bits must be 1 to 28");
  if (o.bits && !predictive && !within(*o.bits, 3, 16)) return invalid_option("bits must be 3 to 16");
  if (o.step && !(std::isfinite(*o.step) && *o.step > 0))
    return invalid_option("step must be a finite number above 0");
  if (o.anchors && o.anchor_density) return invalid_option("anchors and anchor density exclude each other");
  if (o.lossless && (!o.quality.empty() || o.bits || o.step || o.anchors || o.anchor_density))
    return invalid_option("lossless excludes a quality, bits, step and anchors");
  if (o.lossless && o.geometry == GeometryCoder::kHighpass)
    return invalid_option("the highpass coder is never lossless");
  if (predictive && (o.anchors || o.anchor_density))
    return invalid_option("the predictive coder has no anchors");
  return {};
}

bool is_bound(double value, double most = std::numeric_limits<double>::max()) noexcept {
  return value >= 0 && value <= most;
}

Result<void> check_attributes(const AttributeQuality& q) noexcept {
  constexpr double kHalfTurn = 180;  // degrees
  constexpr double kMostColor = 255;
  if (!is_bound(q.normal_error, kHalfTurn))
    return invalid_option("the error of normals must be 0 to 180 degrees");
  if (q.tangent_error && !is_bound(*q.tangent_error, kHalfTurn))
    return invalid_option("the error of tangents must be 0 to 180 degrees");
  if (!is_bound(q.uv_error))
    return invalid_option("the error of texture coordinates must be a finite number of at least 0");
  if (q.color_error && !is_bound(*q.color_error, kMostColor))
    return invalid_option("the error of colours must be 0 to 255");
  if (q.color_rms && !(is_bound(*q.color_rms, kMostColor) && *q.color_rms > 0))
    return invalid_option("the mean error of colours must be above 0, and at most 255");
  if (q.color_rms && q.color_error)
    return invalid_option("a mean error and a largest error of colours exclude each other");
  if (!is_bound(q.weight_error))
    return invalid_option("the error of weights must be a finite number of at least 0");
  for (const NamedBound& bound : q.named) {
    if (!is_bound(bound.error))
      return invalid_option("the error of an attribute must be a finite number of at least 0");
    if (bound.is_mean && bound.error == 0)
      return invalid_option("the mean error of an attribute must be above 0");
  }
  return {};
}

}  // namespace

Result<void> validate(const EncodeOptions& o) noexcept {
  DELTAMESH_CHECK(check_quality(o));
  if (!within(o.effort, 0, 2)) return invalid_option("effort must be 0 to 2");
  if (!is_bound(o.source_error))
    return invalid_option("the source's error must be a finite number of at least 0");
  if (o.grid && !is_valid(*o.grid))
    return invalid_option("a grid's numbers must be finite, and its edges above 0");
  DELTAMESH_CHECK(check_steps(o));
  if (o.anchors && *o.anchors == 0) return invalid_option("at least one anchor is needed");
  if (o.anchor_density && (*o.anchor_density < 1 || *o.anchor_density > 65535))
    return invalid_option("anchor density must be 1 to 65535 hops");
  if (!within(o.anchor_bits, kLeastAnchorBits, kMostAnchorBits))
    return invalid_option("anchor bits must be 4 to 24");
  return check_attributes(o.attributes);
}

}  // namespace deltamesh
