// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "part/fitness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "measure/surface.h"
#include "measure/tree/triangle_tree.h"
#include "support/color_value.h"

namespace deltamesh {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// From the vertices of one mesh to the surface of the other.
void add_errors(const Mesh& from, const Surface& vertices, const Mesh& to, const Surface& surface,
                PartErrors& errors) {
  const TriangleTree tree(surface.positions, surface.triangles);
  std::uint32_t hint = 0;
  for (std::size_t v = 0; v < vertices.positions.size(); ++v) {
    const SurfacePoint point = tree.nearest(vertices.positions[v], hint);
    hint = point.triangle;
    errors.max_error = std::max(errors.max_error, std::sqrt(point.squared_distance));
    const std::array<double, 3> weights{point.weights[0], point.weights[1], point.weights[2]};
    for (std::size_t a = 0; a < from.attributes.size(); ++a) {
      for (std::size_t c = 0; c < from.attributes[a].components; ++c) {
        double there = 0;
        for (std::size_t corner = 0; corner < 3; ++corner)
          there +=
              weights[corner] *
              color_value(to.attributes[a], surface.triangles[3 * std::size_t{point.triangle} + corner], c);
        errors.color_error =
            std::max(errors.color_error, std::abs(there - color_value(from.attributes[a], v, c)));
      }
    }
  }
}

bool keeps(const std::optional<float>& bound, double value) noexcept { return !bound || value <= *bound; }

}  // namespace

PartErrors errors_between(const Mesh& source, const Mesh& decoded) {
  if (!std::ranges::equal(source.attributes, decoded.attributes, are_colors))
    return {.max_error = kInfinite, .color_error = kInfinite};
  const Surface original(source, source.origin);
  const Surface approximation(decoded, source.origin);
  PartErrors errors;
  add_errors(source, original, decoded, approximation, errors);
  add_errors(decoded, approximation, source, original, errors);
  return errors;
}

bool satisfies(const PartErrors& errors, const View& view) noexcept {
  return keeps(view.vde, errors.vde) && keeps(view.lfe, errors.lfe) &&
         keeps(view.max_error, errors.max_error) && keeps(view.color_error, errors.color_error) &&
         keeps(view.color_rms, errors.color_rms / kMeanTolerance);
}

}  // namespace deltamesh
