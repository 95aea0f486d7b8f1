// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "attributes/error.h"
#include "attributes/plain/plain.h"
#include "base/byte_writer.h"
#include "base/component.h"
#include "entropy/arrays.h"

namespace deltamesh {
namespace {

/// How all components of an attribute are coded.
struct PlainPlan {
  PlainCoding coding = PlainCoding::kNumbers;
  double step = 0;             ///< 0: exact
  std::size_t on_lattice = 0;  ///< components, the first ones; the others are exact
};

double number_at(const AttributeView& attribute, const AttributeRows& rows, std::size_t row,
                 std::size_t component) noexcept {
  return load_component(attribute.type, rows.row(row) + component * component_size(attribute.type));
}

void write_exact(ByteWriter& out, const AttributeView& attribute, const AttributeRows& rows,
                 std::size_t component) {
  std::vector<std::uint64_t> numbers;
  numbers.reserve(rows.count());
  rows.for_each(component, [&](std::size_t, std::uint64_t bits) { numbers.push_back(bits); });
  out.write(0.0);
  write_differences(out, numbers, static_cast<unsigned>(8 * component_size(attribute.type)));
}

/// False where a value is too many steps from 0, or from another, or is not finite.
bool write_points(ByteWriter& out, const AttributeView& attribute, const AttributeRows& rows,
                  std::size_t component, double step) {
  std::vector<std::int64_t> points;
  points.reserve(rows.count());
  for (std::size_t i = 0; i < rows.count(); ++i) {
    const double point = std::floor(number_at(attribute, rows, i, component) / step + 0.5);
    if (!(std::fabs(point) <= static_cast<double>(kLargestPlainFirst))) return false;
    points.push_back(static_cast<std::int64_t>(point));
  }
  const auto [least, most] = std::minmax_element(points.begin(), points.end());
  const PlainSteps steps{.step = step, .first = points.empty() ? 0 : *least};
  if (!points.empty() && *most - *least > std::numeric_limits<std::uint32_t>::max()) return false;
  std::vector<std::uint64_t> numbers;
  numbers.reserve(points.size());
  for (const std::int64_t point : points) numbers.push_back(static_cast<std::uint64_t>(point - steps.first));
  out.write(steps.step);
  out.write(steps.first);
  write_differences(out, numbers, 32);
  return true;
}

std::optional<std::vector<std::byte>> write_planned(const AttributeView& attribute, const AttributeRows& rows,
                                                    const PlainPlan& plan) {
  ByteWriter out;
  out.write(static_cast<std::uint8_t>(plan.coding));
  for (std::size_t c = 0; c < rows.components(); ++c) {
    if (c >= plan.on_lattice)
      write_exact(out, attribute, rows, c);
    else if (!write_points(out, attribute, rows, c, plan.step))
      return std::nullopt;
  }
  return out.take();
}

bool all_directions(const AttributeRows& rows) {
  for (std::size_t i = 0; i < rows.count(); ++i) {
    const Vec3 vector = rows.vector(i);
    if (vector != Vec3{} && !is_unit(vector)) return false;
  }
  return true;
}

/// The step of components that may be off by `bound`: of integers a whole one.
double step_within(ComponentType type, double bound) noexcept {
  const bool is_float = type == ComponentType::kF32 || type == ComponentType::kF64;
  if (is_float) return 2 * bound;
  return bound >= 1 ? 2 * std::floor(std::min(bound, 0x1p30)) + 1 : 0;
}

/// The coarsest plan of the attribute's kind that may keep `bound`.
PlainPlan plan_within(const AttributeView& attribute, const AttributeRows& rows, double bound) {
  const auto numbers = [&](double of_component) {
    const double step = step_within(attribute.type, of_component);
    return PlainPlan{.step = step, .on_lattice = step > 0 ? rows.components() : 0};
  };
  switch (attribute.kind) {
    case AttributeKind::kNormal:
    case AttributeKind::kTangent: {
      const bool has_shape = attribute.type == ComponentType::kF32 &&
                             rows.components() == (attribute.kind == AttributeKind::kNormal ? 3 : 4);
      if (!has_shape || !all_directions(rows)) return {};
      // All three may be off at once, and directions are a little shorter than 1.
      const double step = 2 * 0.985 * chord_of(std::min(bound, kMostAngle)) / std::sqrt(3.0);
      return {.coding = PlainCoding::kDirections, .step = step, .on_lattice = 3};
    }
    case AttributeKind::kUv:
      return numbers(rows.components() == 2 ? bound / std::sqrt(2.0) : bound);
    case AttributeKind::kColor:
      return numbers(bound * color_unit(attribute.type));
    case AttributeKind::kGeneric:
      return numbers(bound);
    case AttributeKind::kJoints:
    case AttributeKind::kWeights:
      break;
  }
  return {};
}

}  // namespace

std::vector<std::byte> write_plain_attribute(const AttributeView& attribute, const AttributeRows& rows,
                                             double bound) {
  PlainPlan plan = bound > 0 ? plan_within(attribute, rows, bound) : PlainPlan{};
  const Attribute shape{.kind = attribute.kind, .type = attribute.type, .components = attribute.components};
  // Rounding to the type may take a little more than the bound: then once more with a little less.
  for (int i = 0; i < 2 && plan.on_lattice > 0; ++i, plan.step *= 0.99) {
    const auto payload = write_planned(attribute, rows, plan);
    if (!payload) break;
    const auto read = read_plain_values(*payload, shape, static_cast<std::uint32_t>(rows.count()));
    if (read && attribute_error(attribute, rows, *read) <= bound) return *payload;
  }
  return *write_planned(attribute, rows, {});
}

}  // namespace deltamesh
