// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/mean.h"

#include <cmath>
#include <utility>

#include "attributes/coded.h"
#include "attributes/colors/colors.h"
#include "attributes/error.h"
#include "attributes/haar/haar.h"
#include "attributes/lattice/lattice.h"
#include "attributes/models.h"

namespace deltamesh {
std::optional<CodedAttribute> code_at_mean_error(const AttributeView& attribute, const AttributeRows& rows,
                                                 double rms, const AttributeSettings& settings,
                                                 const AttributeSurface& surface) {
  using enum AttributeCoding;
  const ComponentType type = attribute.type;
  std::optional<CodedAttribute> mean;
  std::optional<CodedAttribute> bounded;
  if (attribute.kind == AttributeKind::kColor) {
    // Errors are evenly spread over the whole numbers from -L to L.
    const double largest = std::floor(std::sqrt(0.25 + 3 * rms * rms) - 0.5);
    bounded = code_compact(
        kSurfaceColors,
        write_surface_colors(type, rows, largest, surface, color_models(settings.start), settings.known));
    mean = code_compact(
        kMean, write_haar_colors(type, rows, rms, surface, mean_models(settings.start), settings.about));
  } else {
    // Errors are evenly spread over all numbers from -L to L.
    const double largest = std::sqrt(3.0) * rms;
    bounded = code_compact(kLattice, write_lattice(attribute, rows, largest, settings.effort, surface));
    mean = code_compact(
        kMean, write_haar_numbers(type, rows, rms, surface, mean_models(settings.start), settings.about));
  }
  if (bounded && !(bounded_rms(type, rows, bounded->decoded.values) <= rms)) bounded.reset();
  const bool is_smaller = mean && bounded && bounded->payload.size() <= mean->payload.size();
  return mean && !is_smaller ? std::move(mean) : std::move(bounded);
}

}  // namespace deltamesh
