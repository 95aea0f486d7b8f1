// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "part/measure.h"

#include <algorithm>

#include "measure/measure.h"

namespace deltamesh {
namespace {

Vec3 position_at(std::span<const float> positions, std::size_t vertex) noexcept {
  const float* p = positions.data() + 3 * vertex;
  return {double{p[0]}, double{p[1]}, double{p[2]}};
}

}  // namespace

PartMeasure::PartMeasure(const Mesh& source)
    : weld_(weld_by_position(source.positions, std::vector<std::uint8_t>(source.vertex_count(), 1))) {
  for (const std::uint32_t v : weld_.representative) original_.push_back(position_at(source.positions, v));
  std::vector<std::uint32_t> triangles;
  triangles.reserve(source.triangles.size());
  for (const std::uint32_t v : source.triangles) triangles.push_back(weld_.geometric[v]);
  graph_ = build_adjacency(triangles, static_cast<std::uint32_t>(original_.size()));
  Box box{original_.front(), original_.front()};
  for (const Vec3& p : original_) {
    for (std::size_t k = 0; k < 3; ++k) {
      box.min[k] = std::min(box.min[k], p[k]);
      box.max[k] = std::max(box.max[k], p[k]);
    }
  }
  diagonal_ = box.diagonal();
}

Quality PartMeasure::compare(std::span<const float> positions, std::span<const std::uint32_t> order) const {
  std::vector<Vec3> decoded(original_.size());
  for (std::size_t v = 0; v < order.size(); ++v)
    decoded[weld_.geometric[order[v]]] = position_at(positions, v);
  return measure_quality(graph_, original_, decoded);
}

}  // namespace deltamesh
