// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "patch/color_match.h"

#include <algorithm>
#include <utility>

#include "lattice/source_colors.h"
#include "patch/coder.h"
#include "support/color_value.h"

namespace deltamesh {
namespace {

/// Of one vertex.
double most_color_error(const AttributeQuality& quality) noexcept {
  constexpr double kMostOfMean = 4;
  return quality.color_rms ? kMostOfMean * *quality.color_rms : quality.color_error.value_or(0);
}

bool has_border_color(const Attribute& source, std::uint32_t s, const Attribute& base, std::uint32_t b,
                      std::uint32_t step) noexcept {
  const std::size_t size = component_size(source.type);
  for (std::size_t c = 0; step > 0 && c < source.components; ++c) {
    const auto level = [&](const Attribute& colors, std::size_t vertex) {
      return color_level(colors.type, colors.values.data() + (vertex * colors.components + c) * size);
    };
    if (level(base, b) != border_level(level(source, s), step)) return false;
  }
  return true;
}

}  // namespace

bool keeps_colors(const Mesh& source, std::uint32_t s, const Mesh& base, std::uint32_t b,
                  const AttributeQuality& quality, bool is_border) noexcept {
  for (std::size_t a = 0; a < source.attributes.size(); ++a) {
    const Attribute& ours = source.attributes[a];
    const Attribute& theirs = base.attributes[a];
    if (color_difference(ours, s, theirs, b) > most_color_error(quality)) return false;
    if (is_border && !has_border_color(ours, s, theirs, b, border_step(ours.type, quality))) return false;
  }
  return true;
}

void keep_mean_error(const Mesh& source, const Mesh& base, const AttributeQuality& quality,
                     std::vector<std::uint32_t>& base_of) {
  if (!quality.color_rms) return;
  std::vector<std::pair<double, std::uint32_t>> errors;
  for (std::uint32_t v = 0; v < base_of.size(); ++v)
    if (base_of[v] != kNotJoined) errors.emplace_back(squared_color_error(source, v, base, base_of[v]), v);
  std::ranges::sort(errors);
  const double each =
      *quality.color_rms * *quality.color_rms * static_cast<double>(count_color_values(source));
  double sum = 0;
  double allowed = 0;
  for (const auto& [error, v] : errors) {
    sum += error;
    allowed += each;
    if (sum > allowed) base_of[v] = kNotJoined;
  }
}

}  // namespace deltamesh
