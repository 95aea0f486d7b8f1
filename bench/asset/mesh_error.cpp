// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "asset/mesh_error.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace deltamesh::bench {
namespace {

constexpr double kRounding = 1 + 0x1p-15;  ///< of figures stored as short floats
constexpr double kDegrees = 57.29577951308232;

using Row = std::array<double, 4>;

template <class T>
Row load_row(const Attribute& attribute, std::size_t row, double scale) {
  Row result{};
  for (std::size_t k = 0; k < std::min<std::size_t>(attribute.components, 4); ++k) {
    T value;
    std::memcpy(&value, attribute.values.data() + (row * attribute.components + k) * sizeof(T), sizeof(T));
    result[k] = static_cast<double>(value) * scale;
  }
  return result;
}

/// The integers of colours and weights as fractions of their range, all others as they are.
Row row_of(const Attribute& attribute, std::size_t row, Part part) {
  const bool is_fraction = part == Part::kColors || part == Part::kWeights;
  const auto scale = [&](double range) { return is_fraction ? 1 / range : 1.0; };
  switch (attribute.type) {
    case ComponentType::kI8:
      return load_row<std::int8_t>(attribute, row, scale(127));
    case ComponentType::kU8:
      return load_row<std::uint8_t>(attribute, row, scale(255));
    case ComponentType::kI16:
      return load_row<std::int16_t>(attribute, row, scale(32767));
    case ComponentType::kU16:
      return load_row<std::uint16_t>(attribute, row, scale(65535));
    case ComponentType::kI32:
      return load_row<std::int32_t>(attribute, row, 1);
    case ComponentType::kU32:
      return load_row<std::uint32_t>(attribute, row, 1);
    case ComponentType::kF32:
      return load_row<float>(attribute, row, 1);
    case ComponentType::kF64:
      return load_row<double>(attribute, row, 1);
  }
  return {};
}

/// Degrees between two vectors; 0 where the original has no direction, 180 where only the decoded one lacks
/// it.
double angle(const Row& a, const Row& b) {
  const double cross_x = a[1] * b[2] - a[2] * b[1];
  const double cross_y = a[2] * b[0] - a[0] * b[2];
  const double cross_z = a[0] * b[1] - a[1] * b[0];
  const double dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  if (a[0] == 0 && a[1] == 0 && a[2] == 0) return 0;
  if (b[0] == 0 && b[1] == 0 && b[2] == 0) return 180;
  return kDegrees * std::atan2(std::sqrt(cross_x * cross_x + cross_y * cross_y + cross_z * cross_z), dot);
}

double row_error(Part part, const Row& a, const Row& b) {
  double largest = 0;
  for (std::size_t k = 0; k < 4; ++k) largest = std::max(largest, std::fabs(a[k] - b[k]));
  switch (part) {
    case Part::kNormals:
      return angle(a, b);
    case Part::kTangents:
      return (a[3] < 0) == (b[3] < 0) ? angle(a, b) : 180;
    case Part::kUvs:
      return std::hypot(a[0] - b[0], a[1] - b[1]);
    case Part::kColors:
      return 255 * largest;
    default:
      return largest;
  }
}

}  // namespace

bool is_within(const MeshError& a, const MeshError& b) {
  constexpr double kNothing = 1e-6;  // degrees: of the arc tangent
  bool within = a.rms <= b.rms * kRounding;
  for (std::size_t part = index_of(Part::kNormals); part < index_of(Part::kMorph); ++part)
    within &= a.largest[part] <= b.largest[part] * kRounding + kNothing;
  return within;
}

void MeshErrorMeter::add(const Mesh& original, const Mesh& decoded, std::span<const std::uint32_t> order) {
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
  for (std::size_t i = 0; i < std::min(original.attributes.size(), decoded.attributes.size()); ++i) {
    const Attribute& a = original.attributes[i];
    const Attribute& b = decoded.attributes[i];
    const Part part = part_of(a.kind, a.name);
    double& largest = error_.largest[index_of(part)];
    for (std::size_t v = 0; v < order.size(); ++v)
      largest = std::max(largest, row_error(part, row_of(a, order[v], part), row_of(b, v, part)));
  }
}

MeshError MeshErrorMeter::error() const {
  MeshError result = error_;
  result.rms = places_.empty() ? 0 : std::sqrt(square_sum_ / static_cast<double>(places_.size()));
  return result;
}

}  // namespace deltamesh::bench
