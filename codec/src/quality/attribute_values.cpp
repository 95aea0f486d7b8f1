// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "quality/attribute_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/portable_math.h"

namespace deltamesh {
namespace {

using Value = std::array<double, kMaxValueComponents>;

template <class T>
double number_at(const std::byte* from) noexcept {
  T value{};
  std::memcpy(&value, from, sizeof value);
  return static_cast<double>(value);
}

double number_at(ComponentType type, const std::byte* from) noexcept {
  switch (type) {
    case ComponentType::kI8:
      return number_at<std::int8_t>(from);
    case ComponentType::kU8:
      return number_at<std::uint8_t>(from);
    case ComponentType::kI16:
      return number_at<std::int16_t>(from);
    case ComponentType::kU16:
      return number_at<std::uint16_t>(from);
    case ComponentType::kI32:
      return number_at<std::int32_t>(from);
    case ComponentType::kU32:
      return number_at<std::uint32_t>(from);
    case ComponentType::kF32:
      return number_at<float>(from);
    case ComponentType::kF64:
      break;
  }
  return number_at<double>(from);
}

/// What the number 1 of the kind's unit is in this type.
double unit_of(const AttributeView& attribute) noexcept {
  const bool color = attribute.kind == AttributeKind::kColor;
  const bool part_of_one = attribute.kind == AttributeKind::kUv || attribute.kind == AttributeKind::kWeights;
  if (!color && !(part_of_one && attribute.normalized)) return 1;
  double range = 1;
  if (attribute.type == ComponentType::kU8) range = 255;
  if (attribute.type == ComponentType::kI8) range = 127;
  if (attribute.type == ComponentType::kU16) range = 65535;
  if (attribute.type == ComponentType::kI16) range = 32767;
  return color ? range / 255 : range;
}

void load(const AttributeView& attribute, std::uint32_t vertex, Value& value) noexcept {
  const std::size_t size = component_size(attribute.type);
  const std::byte* const from = attribute.values.data() + std::size_t{vertex} * value_size(attribute);
  const double unit = unit_of(attribute);
  for (std::size_t c = 0; c < attribute.components; ++c)
    value[c] = number_at(attribute.type, from + c * size) / unit;
}

double angle_between(const Value& a, const Value& b) noexcept {
  return portable_degrees_between({a[0], a[1], a[2]}, {b[0], b[1], b[2]});
}

double error_between(AttributeKind kind, std::size_t components, const Value& a, const Value& b) noexcept {
  if (kind == AttributeKind::kNormal && components == 3) return angle_between(a, b);
  if (kind == AttributeKind::kTangent && components == 4) return a[3] == b[3] ? angle_between(a, b) : 180;
  if (kind == AttributeKind::kUv && components == 2) return length({a[0] - b[0], a[1] - b[1], 0});
  double largest = 0;
  for (std::size_t c = 0; c < components; ++c) {
    const double apart = std::fabs(a[c] - b[c]);
    if (std::isnan(apart)) return apart;
    largest = std::max(largest, apart);
  }
  return largest;
}

}  // namespace

double value_error(const AttributeView& a, std::uint32_t i, const AttributeView& b,
                   std::uint32_t j) noexcept {
  const std::byte* const from_a = a.values.data() + std::size_t{i} * value_size(a);
  const std::byte* const from_b = b.values.data() + std::size_t{j} * value_size(b);
  if (a.type == b.type && std::memcmp(from_a, from_b, value_size(a)) == 0) return 0;
  Value of_a{};
  Value of_b{};
  load(a, i, of_a);
  load(b, j, of_b);
  const double error = error_between(a.kind, a.components, of_a, of_b);
  return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
}

}  // namespace deltamesh
