// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The quality of positions if the caller asks for none.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/numbers/vec3.h"
#include "deltamesh/encode.h"

namespace deltamesh {

/// Whether `options` say nothing of how positions are to be coded.
inline bool asks_for_nothing(const EncodeOptions& options) noexcept {
  return options.quality.empty() && !options.bits && !options.step && !options.anchors &&
         !options.anchor_density && !options.lossless;
}

/// A largest error of 0.02 % of the diagonal, and of 4 % of the mean edge, so that the surface's own normals
/// stay within about a degree on average, however fine the mesh is. `triangles`: m x 3 indices into
/// `positions`. O(1): a sample of the faces tells.
inline QualityRequest default_quality(std::span<const std::uint32_t> triangles,
                                      std::span<const Vec3> positions, const Box& box) {
  constexpr double kShareOfDiagonal = 0.0002;
  constexpr double kShareOfEdge = 0.04;
  constexpr std::size_t kSampledFaces = std::size_t{1} << 15;
  const std::size_t faces = triangles.size() / 3;
  const std::size_t stride = faces / kSampledFaces + 1;
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t f = 0; f < faces; f += stride) {
    const Vec3& a = positions[triangles[3 * f]];
    const Vec3& b = positions[triangles[3 * f + 1]];
    const Vec3& c = positions[triangles[3 * f + 2]];
    sum += length(a - b) + length(b - c) + length(c - a);
    count += 3;
  }
  double bound = kShareOfDiagonal * box.diagonal();
  if (count > 0 && sum > 0) bound = std::min(bound, kShareOfEdge * sum / static_cast<double>(count));
  // A single point loses nothing, but a bound has to be above 0.
  return {.max_error = QualityBound{bound > 0 ? bound : 1.0}};
}

}  // namespace deltamesh
