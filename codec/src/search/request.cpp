// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/request.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "base/numbers/short_float.h"
#include "deltamesh/model_states.h"

namespace deltamesh {
namespace {

constexpr double kShareOfDiagonal = 0.0002;
constexpr double kShareOfEdge = 0.04;
constexpr std::size_t kSampledFaces = std::size_t{1} << 15;

/// Of the diagonal: where VDE alone is asked for, no vertex is farther off. A mesh of many vertices has a
/// small VDE however it is bent.
constexpr double kImpliedError = 0.01;

Error unmet(const char* message, double best_value, std::uint64_t best_bytes) noexcept {
  return {.code = ErrorCode::kUnmetRequest,
          .message = message,
          .best_value = best_value,
          .best_bytes = best_bytes};
}

/// Above 1 too where only the declared figure breaks the bound, being rounded up.
double load_of(double achieved, const std::optional<double>& bound) noexcept {
  if (!bound || !(achieved > 0)) return 0;
  const double load = achieved / *bound;
  const bool declared_above = static_cast<double>(short_float_above(achieved)) > *bound;
  return declared_above ? std::max(load, std::nextafter(1.0, 2.0)) : load;
}

double in_model_units(const QualityBound& bound, std::uint64_t vertices, double box, double extent) noexcept {
  switch (bound.unit) {
    case QualityUnit::kDiagonal:
      return bound.value / 100 * extent;
    case QualityUnit::kPaper:  // inverse of paper_form()
      return bound.value * box / std::sqrt(static_cast<double>(std::max<std::uint64_t>(vertices, 1)));
    case QualityUnit::kModel:
      break;
  }
  return bound.value;
}

/// False where nothing is left.
bool take_off(std::optional<double>& bound, double error) noexcept {
  if (!bound || error == 0) return true;
  *bound -= error;
  return *bound > 0;
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

Quality with_source_error(Quality quality, double error) noexcept {
  quality.vde_rms += 2 * error;
  quality.lfe_rms += error;
  quality.max_error += error;
  return quality;
}

Bounds bounds_in_model_units(const QualityRequest& request, std::uint64_t vertices, double box,
                             double extent) noexcept {
  Bounds bounds;
  if (request.vde) bounds.vde = in_model_units(*request.vde, vertices, box, extent);
  if (request.lfe) bounds.lfe = in_model_units(*request.lfe, vertices, box, extent);
  if (request.max_error && request.max_error->value != kNoBound.value)
    bounds.max_error = in_model_units(*request.max_error, vertices, box, extent);
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
  const bool no_bound = request.max_error && request.max_error->value == kNoBound.value;
  if (request.max_error && !no_bound && !is_positive(request.max_error->value))
    return invalid("the maximum error must be a finite number above 0");
  if (request.max_error && request.max_error->unit == QualityUnit::kPaper)
    return invalid("the paper has no form of the maximum error");
  if (no_bound && !request.vde && !request.lfe && !request.target_bytes)
    return invalid("without a limit on the maximum error, a VDE, an LFE or target bytes must be asked for");
  if (request.target_bytes && *request.target_bytes == 0)
    return invalid("the target size must be above 0 bytes");
  return {};
}

bool says_nothing_of_positions(const EncodeOptions& options) noexcept {
  return options.quality.empty() && !options.bits && !options.step && !options.anchors &&
         !options.anchor_density && !options.lossless;
}

double default_error(std::span<const std::uint32_t> triangles, std::span<const Vec3> positions,
                     const Extent& extent) noexcept {
  const std::size_t faces = triangles.size() / 3;
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t f = 0; f < faces; f += faces / kSampledFaces + 1) {
    const Vec3& a = positions[triangles[3 * f]];
    const Vec3& b = positions[triangles[3 * f + 1]];
    const Vec3& c = positions[triangles[3 * f + 2]];
    if (extent.is_stray(a) || extent.is_stray(b) || extent.is_stray(c)) continue;
    sum += length(a - b) + length(b - c) + length(c - a);
    count += 3;
  }
  double bound = kShareOfDiagonal * extent.diagonal;
  if (count > 0 && sum > 0) bound = std::min(bound, kShareOfEdge * sum / static_cast<double>(count));
  return bound > 0 ? bound : 1.0;  // a single point loses nothing
}

Result<Request> make_request(const EncodeOptions& options, const SourceGeometry& source) {
  Request request{.bounds = bounds_in_model_units(options.quality, source.positions.size(),
                                                  source.box.diagonal(), source.extent.diagonal),
                  .target_bytes = options.quality.target_bytes,
                  .step = options.step,
                  .bits = options.bits,
                  .anchors = options.anchors,
                  .anchor_density = options.anchor_density,
                  .anchor_bits = options.anchor_bits,
                  .lossless = options.lossless,
                  .coder = options.geometry,
                  .profile = options.profile,
                  .effort = options.effort,
                  .containers = options.anchor_containers ? options.anchor_containers.get() : nullptr,
                  .start = options.starting_states != nullptr ? &options.starting_states->models() : nullptr,
                  .grid = options.grid,
                  .known = options.known};
  // Of what nobody asked for, as much as the source's own error allows.
  const auto but = [&](double bound) { return std::max(bound - options.source_error, bound / 2); };
  const bool keeps = take_off(request.bounds.vde, 2 * options.source_error) &&
                     take_off(request.bounds.lfe, options.source_error) &&
                     take_off(request.bounds.max_error, options.source_error);
  if (!keeps)
    return unmet("the bound asked for is less than what coordinates lost as they became float32",
                 options.source_error, 0);
  if (says_nothing_of_positions(options))
    request.bounds.max_error = but(default_error(source.triangles, source.positions, source.extent));
  const double implied = kImpliedError * source.extent.diagonal;
  if (options.quality.vde && !options.quality.lfe && !options.quality.max_error && implied > 0)
    request.bounds.max_error = but(implied);
  return request;
}

Error unmet_bounds(const Bounds& bounds, const Quality& quality, std::uint64_t bytes) noexcept {
  const double worst = bounds.load(quality);
  if (bounds.vde && bounds.visual_load(quality) >= worst)
    return unmet("the VDE asked for cannot be had for this mesh", quality.vde_rms, bytes);
  if (bounds.lfe && Bounds{.lfe = bounds.lfe}.load(quality) >= worst)
    return unmet("the LFE asked for cannot be had for this mesh", quality.lfe_rms, bytes);
  return unmet("the maximum error asked for cannot be had for this mesh", quality.max_error, bytes);
}

Error too_few_bytes(std::uint64_t bytes) noexcept {
  return unmet("no stream of this mesh is so small", 0, bytes);
}

Error too_few_bytes_for_bounds(std::uint64_t bytes) noexcept {
  return unmet("the quality asked for needs more bytes than allowed", 0, bytes);
}

}  // namespace deltamesh
