// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/error.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "attributes/payload.h"
#include "base/component.h"
#include "format/chunk/attribute_descriptor.h"

namespace deltamesh {
namespace {

/// A row's values as numbers, as far as an error needs them.
using Row = std::array<double, kMaxComponents>;

double angle_between(const Row& a, const Row& b) noexcept {
  return portable_degrees_between({a[0], a[1], a[2]}, {b[0], b[1], b[2]});
}

double largest_difference(const Row& a, const Row& b, std::size_t components) noexcept {
  double largest = 0;
  for (std::size_t c = 0; c < components; ++c) largest = std::max(largest, std::fabs(a[c] - b[c]));
  return largest;
}

double row_error(const AttributeView& attribute, const Row& a, const Row& b) noexcept {
  const std::size_t components = attribute.components;
  switch (attribute.kind) {
    case AttributeKind::kNormal:
      if (components == 3) return angle_between(a, b);
      break;
    case AttributeKind::kTangent:
      if (components == 4 && a[3] == b[3]) return angle_between(a, b);
      if (components == 4) return 180;
      break;
    case AttributeKind::kUv:
      if (components == 2) return length({a[0] - b[0], a[1] - b[1], 0});
      break;
    case AttributeKind::kColor:
      return largest_difference(a, b, components) / color_unit(attribute.type);
    case AttributeKind::kWeights:
      return largest_difference(a, b, components) / normalized_one(attribute.type);
    case AttributeKind::kGeneric:
    case AttributeKind::kJoints:
      break;
  }
  return largest_difference(a, b, components);
}

constexpr bool measures_angles(const AttributeView& attribute) noexcept {
  return (attribute.kind == AttributeKind::kNormal && attribute.components == 3) ||
         (attribute.kind == AttributeKind::kTangent && attribute.components == 4);
}

/// The square of the angle's cosine, with its sign: falls where the angle grows. Cheaper than that.
double cosine_square(const Row& a, const Row& b) noexcept {
  const double product = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const double lengths =
      (a[0] * a[0] + a[1] * a[1] + a[2] * a[2]) * (b[0] * b[0] + b[1] * b[1] + b[2] * b[2]);
  return product * std::fabs(product) / lengths;
}

/// The largest error that a descriptor can tell; larger bounds are cut to it.
constexpr double kLargestBound = 0x1p127;

const NamedBound* find_bound(const AttributeView& attribute, const AttributeQuality& quality) noexcept {
  if (attribute.kind != AttributeKind::kGeneric) return nullptr;
  const auto& all = quality.named;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const NamedBound& b) { return b.name == attribute.name; });
  return found == all.end() ? nullptr : &*found;
}

double asked_bound(const AttributeView& attribute, const AttributeQuality& quality) noexcept {
  switch (attribute.kind) {
    case AttributeKind::kNormal:
      return std::min(quality.normal_error, kMostAngle);
    case AttributeKind::kTangent:
      return std::min(quality.tangent_error.value_or(quality.normal_error), kMostAngle);
    case AttributeKind::kUv:
      return quality.uv_error;
    case AttributeKind::kColor:
      return quality.color_error.value_or(quality.color_rms.value_or(0));
    case AttributeKind::kWeights:
      return quality.weight_error;
    case AttributeKind::kJoints:
      return 0;
    case AttributeKind::kGeneric:
      break;
  }
  const NamedBound* const named = find_bound(attribute, quality);
  return named != nullptr ? named->error : 0;
}

constexpr std::size_t kColors = 3;

/// Over components `first` up to `end`, in the values' unit; bits that are the same have no error.
double rms_of(std::size_t first, std::size_t end, ComponentType type, const AttributeRows& rows,
              std::span<const std::byte> decoded) noexcept {
  const std::size_t size = component_size(type);
  double sum = 0;
  const std::byte* now = decoded.data();
  for (std::size_t i = 0; i < rows.count(); ++i, now += rows.components() * size) {
    const std::byte* const source = rows.row(i);
    for (std::size_t c = first; c < end; ++c) {
      if (std::memcmp(source + c * size, now + c * size, size) == 0) continue;
      const double error = load_component(type, source + c * size) - load_component(type, now + c * size);
      sum += error * error;
    }
  }
  const std::size_t count = (end - first) * rows.count();
  return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0;
}

}  // namespace

double color_unit(ComponentType type) noexcept {
  if (type == ComponentType::kU8) return 1;
  return type == ComponentType::kU16 ? 257 : 1.0 / 255;
}

double bound_of(const AttributeView& attribute, const AttributeQuality& quality) noexcept {
  return std::min(asked_bound(attribute, quality), kLargestBound);
}

std::optional<double> mean_bound_of(const AttributeView& attribute,
                                    const AttributeQuality& quality) noexcept {
  if (!coding_fits(AttributeCoding::kMean, attribute.kind, attribute.type, attribute.components))
    return std::nullopt;
  if (attribute.kind == AttributeKind::kColor) return quality.color_rms;
  const NamedBound* const named = find_bound(attribute, quality);
  return named != nullptr && named->is_mean ? std::optional(named->error) : std::nullopt;
}

std::uint64_t count_dropped_lengths(const AttributeView& attribute, const AttributeQuality& quality) {
  const double bound = bound_of(attribute, quality);
  const bool is_angle = measures_angles(attribute) && attribute.type == ComponentType::kF32;
  if (!is_angle || !(bound >= kLeastAngle)) return 0;
  std::uint64_t count = 0;
  const std::size_t row = attribute.components * sizeof(float);
  for (std::size_t at = 0; at + row <= attribute.values.size(); at += row) {
    std::array<float, 3> vector{};
    std::memcpy(vector.data(), attribute.values.data() + at, sizeof(vector));
    const Vec3 wide = widen(vector);
    count += is_direction(wide) && !is_unit(wide) ? 1 : 0;
  }
  return count;
}

double attribute_error(const AttributeView& attribute, const AttributeRows& rows,
                       std::span<const std::byte> decoded) {
  double largest = 0;
  constexpr double kRounding = 1e-12;  // far more than cosines are off by
  double least_cosine = 2;             // its square
  const bool is_angle = measures_angles(attribute);
  Row a{};
  Row b{};
  const std::size_t size = component_size(attribute.type);
  const std::byte* now = decoded.data();
  for (std::size_t i = 0; i < rows.count(); ++i, now += attribute.components * size) {
    const std::byte* const source = rows.row(i);
    if (std::memcmp(source, now, attribute.components * size) == 0) continue;
    for (std::size_t c = 0; c < attribute.components; ++c) {
      a[c] = load_component(attribute.type, source + c * size);
      b[c] = load_component(attribute.type, now + c * size);
    }
    if (is_angle && a[3] == b[3]) {  // a normal has no sign
      const double cosine = cosine_square(a, b);
      if (cosine > least_cosine + kRounding) continue;
      least_cosine = std::fmin(least_cosine, cosine);
    }
    const double error = row_error(attribute, a, b);
    if (!(error <= largest)) largest = std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
  }
  return largest;
}

double color_rms(ComponentType type, const AttributeRows& rows, std::span<const std::byte> decoded) noexcept {
  return rms_of(0, kColors, type, rows, decoded) / color_unit(type);
}

double bounded_rms(ComponentType type, const AttributeRows& rows,
                   std::span<const std::byte> decoded) noexcept {
  if (rows.components() == 1) return rms_of(0, 1, type, rows, decoded);
  const double alpha = rms_of(kColors, rows.components(), type, rows, decoded) / color_unit(type);
  return std::max(color_rms(type, rows, decoded), alpha);
}

double attribute_rms(const AttributeView& attribute, const AttributeRows& rows,
                     std::span<const std::byte> decoded) noexcept {
  return attribute.kind == AttributeKind::kColor ? color_rms(attribute.type, rows, decoded)
                                                 : rms_of(0, 1, attribute.type, rows, decoded);
}

}  // namespace deltamesh
