// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Bytes of one map's colours against their error, coder by coder.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "deltamesh/mesh.h"

namespace deltamesh::bench {

enum class ColorCoder : std::uint8_t { kBounds, kTransform, kOctree, kOctreeUnpredicted, kDraco };
inline constexpr std::array<std::string_view, 5> kColorCoderNames = {
    "within bounds", "transform over the mesh", "RAHT, predicted", "RAHT", "Draco, fewer bits"};

struct RatePoint {
  double decibels = 0;    ///< PSNR of luma
  double difference = 0;  ///< mean CIEDE2000
  std::uint64_t bytes = 0;
};

/// What a coder takes at one mean error.
struct ColorRate {
  double bytes = 0;
  double difference = 0;  ///< mean CIEDE2000
};

struct ColorCurves {
  std::uint64_t vertices = 0;
  std::array<std::vector<RatePoint>, kColorCoderNames.size()> points;  ///< by ColorCoder, errors rising

  /// At a PSNR of luma: logarithms are taken for lines between two points and beyond the last ones.
  ColorRate at(ColorCoder coder, double decibels) const;
};

/// Nothing for a mesh without 8-bit colours. Predictive geometry, effort 0. Exits where a codec fails.
std::optional<ColorCurves> measure_color_curves(Mesh loaded);

}  // namespace deltamesh::bench
