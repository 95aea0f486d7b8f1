// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "report/heatmap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace deltamesh::cli {
namespace {

/// `share`: error over scale, -1 to 1.
std::array<float, 3> color_of(float share) {
  const float size = std::min(std::abs(share), 1.0F);
  const float warm = std::min(2 * size, 1.0F);       // grows over the first half
  const float green = std::min(2 - 2 * size, 1.0F);  // falls over the second
  return share < 0 ? std::array{0.0F, green, warm} : std::array{warm, green, 0.0F};
}

}  // namespace

float heatmap_scale(std::span<const float> errors) {
  if (errors.empty()) return 0;
  std::vector<float> sizes(errors.size());
  std::transform(errors.begin(), errors.end(), sizes.begin(), [](float e) { return std::abs(e); });
  const auto rank = static_cast<std::ptrdiff_t>(std::ceil(0.95 * static_cast<double>(sizes.size()))) - 1;
  std::nth_element(sizes.begin(), sizes.begin() + rank, sizes.end());
  const float percentile = sizes[static_cast<std::size_t>(rank)];
  return percentile > 0 ? percentile : *std::max_element(sizes.begin(), sizes.end());
}

Mesh heatmap(const Mesh& mesh, std::span<const float> errors, float scale) {
  Attribute colors;
  colors.kind = AttributeKind::kColor;
  colors.type = ComponentType::kU8;
  colors.components = 3;
  colors.normalized = true;
  colors.name = "color";
  colors.values.reserve(3 * errors.size());
  for (const float error : errors)
    for (const float component : color_of(scale > 0 ? error / scale : 0.0F))
      colors.values.push_back(static_cast<std::byte>(std::lround(255 * component)));
  Mesh colored;
  colored.origin = mesh.origin;
  colored.positions = mesh.positions;
  colored.triangles = mesh.triangles;
  colored.attributes.push_back(std::move(colors));
  return colored;
}

}  // namespace deltamesh::cli
