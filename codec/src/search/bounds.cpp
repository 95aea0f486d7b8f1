// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/numbers/short_float.h"

namespace deltamesh {
namespace {

/// Above 1 too where only the declared figure breaks the bound, being rounded up.
double load_of(double achieved, const std::optional<double>& bound) noexcept {
  if (!bound || !(achieved > 0)) return 0;
  const double load = achieved / *bound;
  const bool declared_above = static_cast<double>(short_float_above(achieved)) > *bound;
  return declared_above ? std::max(load, std::nextafter(1.0, 2.0)) : load;
}

double in_model_units(const QualityBound& bound, std::uint64_t vertices, double diagonal) noexcept {
  switch (bound.unit) {
    case QualityUnit::kDiagonal:
      return bound.value / 100 * diagonal;
    case QualityUnit::kPaper:  // inverse of paper_form()
      return bound.value * diagonal / std::sqrt(static_cast<double>(std::max<std::uint64_t>(vertices, 1)));
    case QualityUnit::kModel:
      break;
  }
  return bound.value;
}

bool is_positive(double value) noexcept { return std::isfinite(value) && value > 0; }

}  // namespace

bool is_declarable(const Quality& quality) noexcept {
  return std::isfinite(short_float_above(std::max({quality.vde_rms, quality.lfe_rms, quality.max_error})));
}

double Bounds::visual_load(const Quality& quality) const noexcept { return load_of(quality.vde_rms, vde); }

double Bounds::positional_load(const Quality& quality) const noexcept {
  return std::max(load_of(quality.lfe_rms, lfe), load_of(quality.max_error, max_error));
}

double Bounds::load(const Quality& quality) const noexcept {
  if (!is_declarable(quality)) return std::numeric_limits<double>::infinity();
  return std::max(visual_load(quality), positional_load(quality));
}

Bounds bounds_in_model_units(const QualityRequest& request, std::uint64_t vertices,
                             double diagonal) noexcept {
  Bounds bounds;
  if (request.vde) bounds.vde = in_model_units(*request.vde, vertices, diagonal);
  if (request.lfe) bounds.lfe = in_model_units(*request.lfe, vertices, diagonal);
  if (request.max_error) bounds.max_error = in_model_units(*request.max_error, vertices, diagonal);
  return bounds;
}

Result<void> validate(const QualityRequest& request) noexcept {
  const auto invalid = [](const char* message) {
    return Error{.code = ErrorCode::kInvalidArgument, .message = message};
  };
  if (request.vde && !is_positive(request.vde->value))
    return invalid("the VDE asked for must be a finite number above 0");
  if (request.lfe && !is_positive(request.lfe->value))
    return invalid("the LFE asked for must be a finite number above 0");
  if (request.max_error && !is_positive(request.max_error->value))
    return invalid("the maximum error must be a finite number above 0");
  if (request.max_error && request.max_error->unit == QualityUnit::kPaper)
    return invalid("the paper has no form of the maximum error");
  if (request.target_bytes && *request.target_bytes == 0)
    return invalid("the target size must be above 0 bytes");
  return {};
}

}  // namespace deltamesh
