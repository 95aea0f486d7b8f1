// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <cmath>

#include "base/try.h"
#include "deltamesh/encode.h"
#include "quality/bounds.h"

namespace deltamesh {
namespace {

Error invalid(const char* message) noexcept {
  return {.code = ErrorCode::kInvalidArgument, .message = message};
}

bool within(int value, int least, int most) noexcept { return value >= least && value <= most; }

/// What the request would set is not set by hand.
Result<void> check_quality(const EncodeOptions& o) noexcept {
  const QualityRequest& q = o.quality;
  DELTAMESH_CHECK(validate(q));
  if ((q.vde || q.max_error || q.target_bytes) && (o.bits || o.step))
    return invalid("VDE, maximum error and target bytes set the step: bits and step exclude them");
  if ((q.lfe || q.max_error) && (o.anchors || o.anchor_density))
    return invalid("LFE and maximum error set the anchors: anchors and anchor density exclude them");
  return {};
}

/// Bits, step and anchors by hand.
Result<void> check_steps(const EncodeOptions& o) noexcept {
  const bool predictive = o.geometry == GeometryCoder::kPredictive;
  if (o.bits && o.step) return invalid("bits and step exclude each other");
  if (o.bits && predictive && !within(*o.bits, 1, 28)) return invalid("bits must be 1 to 28");
  if (o.bits && !predictive && !within(*o.bits, 3, 16)) return invalid("bits must be 3 to 16");
  if (o.step && !(std::isfinite(*o.step) && *o.step > 0))
    return invalid("step must be a finite number above 0");
  if (o.anchors && o.anchor_density) return invalid("anchors and anchor density exclude each other");
  if (o.lossless && (!o.quality.empty() || o.bits || o.step || o.anchors || o.anchor_density))
    return invalid("lossless excludes a quality, bits, step and anchors");
  if (o.lossless && o.geometry == GeometryCoder::kHighpass)
    return invalid("the highpass coder is never lossless");
  if (o.lossless && o.profile == Profile::kZstd)
    return invalid("lossless has a compact form only, which the zstd profile excludes");
  if (predictive && (o.anchors || o.anchor_density)) return invalid("the predictive coder has no anchors");
  if (predictive && o.profile == Profile::kZstd)
    return invalid("the predictive coder has a compact form only, which the zstd profile excludes");
  return {};
}

}  // namespace

Result<void> validate(const EncodeOptions& o) noexcept {
  DELTAMESH_CHECK(check_quality(o));
  if (!within(o.effort, 0, 9)) return invalid("effort must be 0 to 9");
  DELTAMESH_CHECK(check_steps(o));
  if (o.anchors && *o.anchors == 0) return invalid("at least one anchor is needed");
  if (o.anchor_density && (*o.anchor_density < 1 || *o.anchor_density > 65535))
    return invalid("anchor density must be 1 to 65535 hops");
  if (!within(o.anchor_bits, 4, 24)) return invalid("anchor bits must be 4 to 24");
  if (!within(o.normal_bits, 2, 15)) return invalid("normal bits must be 2 to 15");
  if (!within(o.color_bits, 1, 16)) return invalid("colour bits must be 1 to 16");
  if (!within(o.uv_bits, 1, 24)) return invalid("texture coordinate bits must be 1 to 24");
  return {};
}

}  // namespace deltamesh
