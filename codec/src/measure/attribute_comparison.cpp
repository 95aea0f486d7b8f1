// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "measure/attribute_comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

#include "base/component.h"
#include "base/numbers/portable_math.h"
#include "base/numbers/srgb.h"
#include "format/chunk/attribute_descriptor.h"
#include "measure/colors/color_difference.h"

namespace deltamesh {
namespace {

/// Bytes of one value.
inline std::size_t value_size(const AttributeView& attribute) noexcept {
  return attribute.components * component_size(attribute.type);
}

using Value = std::array<double, kMaxComponents>;

/// What the number 1 of the kind's unit is in this type.
double unit_of(const AttributeView& attribute) noexcept {
  const double one = normalized_one(attribute.type);
  switch (attribute.kind) {
    case AttributeKind::kColor:
      return one / 255;
    case AttributeKind::kWeights:
      return one;
    case AttributeKind::kUv:
      return attribute.normalized ? one : 1;
    default:
      return 1;
  }
}

/// `shown`: a linear colour as a screen shows it.
void load(const AttributeView& attribute, std::uint32_t vertex, bool shown, Value& value) noexcept {
  const std::size_t size = component_size(attribute.type);
  const std::byte* const from = attribute.values.data() + std::size_t{vertex} * value_size(attribute);
  const double unit = unit_of(attribute);
  for (std::size_t c = 0; c < attribute.components; ++c)
    value[c] = load_component(attribute.type, from + c * size) / unit;
  if (!shown || !attribute.linear) return;
  for (std::size_t c = 0; c < std::min<std::size_t>(attribute.components, 3); ++c)
    value[c] = 255 * shown_of_linear(value[c] / 255);
}

double degrees_between(const Value& a, const Value& b) noexcept {
  return portable_degrees_between({a[0], a[1], a[2]}, {b[0], b[1], b[2]});
}

double error_between(AttributeKind kind, std::size_t components, const Value& a, const Value& b) noexcept {
  if (kind == AttributeKind::kNormal && components == 3) return degrees_between(a, b);
  if (kind == AttributeKind::kTangent && components == 4) return a[3] == b[3] ? degrees_between(a, b) : 180;
  if (kind == AttributeKind::kUv && components == 2) return length({a[0] - b[0], a[1] - b[1], 0});
  double largest = 0;
  for (std::size_t c = 0; c < components; ++c) {
    const double apart = std::fabs(a[c] - b[c]);
    if (std::isnan(apart)) return apart;
    largest = std::max(largest, apart);
  }
  return largest;
}

/// Value `i` of `a` against value `j` of `b`, which has as many components, in the unit of Comparison:
/// degrees, distance of texture coordinates, 255ths of a colour's range, else the largest difference of a
/// component, where weights of integer types are parts of 1. 0 where all bits are the same, infinity where
/// the difference is not a number. O(1).
double value_error(const AttributeView& a, std::uint32_t i, const AttributeView& b,
                   std::uint32_t j) noexcept {
  const std::byte* const from_a = a.values.data() + std::size_t{i} * value_size(a);
  const std::byte* const from_b = b.values.data() + std::size_t{j} * value_size(b);
  const bool shown = a.kind == AttributeKind::kColor && a.linear != b.linear;
  if (!shown && a.type == b.type && std::memcmp(from_a, from_b, value_size(a)) == 0) return 0;
  Value of_a{};
  Value of_b{};
  load(a, i, shown, of_a);
  load(b, j, shown, of_b);
  const double error = error_between(a.kind, a.components, of_a, of_b);
  return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
}

constexpr std::size_t kColors = 3;

/// Sums over pairs of colours of 3 components or more.
class ColorErrors {
 public:
  /// Their CIEDE2000.
  double add(const AttributeView& a, std::uint32_t i, const AttributeView& b, std::uint32_t j) noexcept {
    const bool shown = a.linear != b.linear;
    Value of_a{};
    Value of_b{};
    load(a, i, shown, of_a);
    load(b, j, shown, of_b);
    for (std::size_t c = 0; c < kColors; ++c) squares_ += (of_a[c] - of_b[c]) * (of_a[c] - of_b[c]);
    const double difference = color_difference(shown_color(a, i), shown_color(b, j));
    differences_ += difference;
    return difference;
  }

  void finish(AttributeComparison& result) const noexcept {
    const auto count = static_cast<double>(result.measured);
    const double rms = std::sqrt(squares_ / (kColors * count));
    result.color_rms = std::isfinite(rms) ? rms : std::numeric_limits<double>::infinity();
    const double mean = differences_ / count;
    result.color_difference = std::isfinite(mean) ? mean : std::numeric_limits<double>::infinity();
  }

 private:
  static std::array<double, kColors> shown_color(const AttributeView& attribute,
                                                 std::uint32_t vertex) noexcept {
    Value value{};
    load(attribute, vertex, true, value);
    return {value[0] / 255, value[1] / 255, value[2] / 255};
  }

  double squares_ = 0;
  double differences_ = 0;
};

bool has_color(const AttributeView& attribute) noexcept {
  return attribute.kind == AttributeKind::kColor && attribute.components >= kColors;
}

bool comparable(const AttributeView& a, const AttributeView& b) noexcept {
  const bool of_one_range = a.kind == AttributeKind::kColor || a.normalized == b.normalized;
  return a.kind == b.kind && a.components == b.components && of_one_range;
}

/// A difference that is clearly visible or otherwise large, in the kind's unit.
double large_difference(AttributeKind kind) noexcept {
  switch (kind) {
    case AttributeKind::kNormal:
    case AttributeKind::kTangent:
      return 30;
    case AttributeKind::kColor:
      return 64;
    case AttributeKind::kUv:
    case AttributeKind::kWeights:
      return 0.1;
    case AttributeKind::kGeneric:
    case AttributeKind::kJoints:
      break;
  }
  return 1;
}

/// glTF puts an underscore before names of its own choice.
std::string_view plain_name(std::string_view name) noexcept {
  return name.substr(name.starts_with('_') ? 1 : 0);
}

bool stand_for_each_other(const AttributeView& a, const AttributeView& b, bool by_name) noexcept {
  if (by_name) return plain_name(a.name) == plain_name(b.name) && !a.name.empty();
  return a.kind == b.kind && a.kind != AttributeKind::kGeneric;
}

AttributeComparison without_errors(const AttributeView& attribute, AttributeMatch match) {
  return {.name = std::string(attribute.name), .kind = attribute.kind, .match = match};
}

}  // namespace

AttributeComparer::AttributeComparer(const MeshView& a, const MeshView& b) {
  std::vector<const AttributeView*> partner(a.attributes.size());
  std::vector<bool> taken(b.attributes.size());
  for (const bool by_name : {true, false})
    for (std::size_t i = 0; i < partner.size(); ++i)
      for (std::size_t j = 0; j < taken.size() && partner[i] == nullptr; ++j) {
        if (taken[j] || !stand_for_each_other(a.attributes[i], b.attributes[j], by_name)) continue;
        partner[i] = &b.attributes[j];
        taken[j] = true;
      }
  for (std::size_t i = 0; i < partner.size(); ++i) {
    const AttributeView& of_a = a.attributes[i];
    if (partner[i] == nullptr)
      pairs_.push_back({of_a, {}, without_errors(of_a, AttributeMatch::kMissingInB)});
    else
      pairs_.push_back({of_a, *partner[i],
                        without_errors(of_a, comparable(of_a, *partner[i]) ? AttributeMatch::kCompared
                                                                           : AttributeMatch::kOtherType)});
  }
  for (std::size_t j = 0; j < taken.size(); ++j)
    if (!taken[j])
      pairs_.push_back({{}, b.attributes[j], without_errors(b.attributes[j], AttributeMatch::kOnlyInB)});
}

double AttributeComparer::difference(std::uint32_t a, std::uint32_t b) const {
  double sum = 0;
  for (const Pair& pair : pairs_) {
    if (pair.result.match != AttributeMatch::kCompared) continue;
    const double apart = value_error(pair.a, a, pair.b, b);
    const double large = large_difference(pair.a.kind);
    sum += std::isfinite(apart) ? apart / (apart + large) : 1;
  }
  return sum;
}

const AttributeComparer::Pair* AttributeComparer::first_colors() const noexcept {
  const auto found = std::find_if(pairs_.begin(), pairs_.end(), [](const Pair& pair) {
    return pair.result.match == AttributeMatch::kCompared && has_color(pair.a);
  });
  return found == pairs_.end() ? nullptr : &*found;
}

std::vector<AttributeComparison> AttributeComparer::compare(std::span<const VertexPair> vertices,
                                                            std::span<float> color_difference) const {
  std::vector<AttributeComparison> results;
  const Pair* const shown = first_colors();
  for (const Pair& pair : pairs_) {
    AttributeComparison result = pair.result;
    if (result.match == AttributeMatch::kCompared && !vertices.empty()) {
      double sum = 0;
      double squares = 0;
      ColorErrors colors;
      for (const VertexPair& vertex : vertices) {
        const double error = value_error(pair.a, vertex.a, pair.b, vertex.b);
        result.max_error = std::max(result.max_error, error);
        sum += error;
        squares += error * error;
        if (!has_color(pair.a) || error == 0) continue;
        const double difference = colors.add(pair.a, vertex.a, pair.b, vertex.b);
        if (&pair != shown) continue;
        float& worst = color_difference[vertex.b];
        worst = std::max(worst, static_cast<float>(difference));
      }
      result.measured = vertices.size();
      const auto count = static_cast<double>(vertices.size());
      result.mean = sum / count;
      result.rms = std::sqrt(squares / count);
      if (has_color(pair.a)) colors.finish(result);
    }
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace deltamesh
