// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "part/measure.h"

#include "measure/measure.h"

namespace deltamesh {

PartMeasure::PartMeasure(const Mesh& source)
    : weld_(weld_by_position(source.positions, std::vector<std::uint8_t>(source.vertex_count(), 1))) {
  for (const std::uint32_t v : weld_.representative)
    original_.push_back(widen(source.positions.data() + 3 * std::size_t{v}));
  std::vector<std::uint32_t> triangles;
  triangles.reserve(source.triangles.size());
  for (const std::uint32_t v : source.triangles) triangles.push_back(weld_.geometric[v]);
  graph_ = build_adjacency(triangles, static_cast<std::uint32_t>(original_.size()));
  diagonal_ = Box::around(original_).diagonal();
}

Quality PartMeasure::compare(std::span<const float> positions, std::span<const std::uint32_t> order) const {
  std::vector<Vec3> decoded(original_.size());
  for (std::size_t v = 0; v < order.size(); ++v)
    decoded[weld_.geometric[order[v]]] = widen(positions.data() + 3 * v);
  return measure_quality(graph_, original_, decoded);
}

}  // namespace deltamesh
