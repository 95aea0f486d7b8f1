// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "asset/mesh_error.h"

#include <algorithm>
#include <cmath>

#include "base/try.h"
#include "deltamesh/compare.h"

namespace deltamesh::bench {

bool is_within(const MeshError& a, const MeshError& b) {
  constexpr double kRounding = 1 + 0x1p-15;  // of figures stored as short floats
  constexpr double kNothing = 1e-6;          // degrees: of the arc tangent
  bool within = a.rms <= b.rms * kRounding;
  for (std::size_t part = index_of(Part::kNormals); part < index_of(Part::kMorph); ++part)
    within &= a.largest[part] <= b.largest[part] * kRounding + kNothing;
  return within;
}

Result<void> MeshErrorMeter::add(const Mesh& original, const Mesh& decoded,
                                 std::span<const std::uint32_t> order) {
  for (std::size_t v = 0; v < order.size(); ++v) {
    const float* a = original.positions.data() + std::size_t{3} * order[v];
    const float* b = decoded.positions.data() + 3 * v;
    double square = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double difference = static_cast<double>(a[axis]) - static_cast<double>(b[axis]);
      square += difference * difference;
    }
    double& largest = error_.largest[index_of(Part::kGeometry)];
    largest = std::max(largest, std::sqrt(square));
    if (places_.emplace(reinterpret_cast<const char*>(a), 3 * sizeof(float)).second) square_sum_ += square;
  }
  DELTAMESH_TRY(const Comparison comparison, compare(original, decoded, order));
  for (const AttributeComparison& attribute : comparison.attributes) {
    double& largest = error_.largest[index_of(part_of(attribute.kind, attribute.name))];
    largest = std::max(largest, attribute.max_error);
  }
  return {};
}

MeshError MeshErrorMeter::error() const {
  MeshError result = error_;
  result.rms = places_.empty() ? 0 : std::sqrt(square_sum_ / static_cast<double>(places_.size()));
  return result;
}

}  // namespace deltamesh::bench
