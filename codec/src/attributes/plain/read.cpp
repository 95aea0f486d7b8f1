// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <array>
#include <cmath>
#include <vector>

#include "attributes/lattice/component_lattice.h"
#include "attributes/plain/plain.h"
#include "attributes/values.h"
#include "base/byte_reader.h"
#include "base/try.h"
#include "entropy/arrays.h"
#include "format/chunk/tags.h"

namespace deltamesh {
namespace {

using Columns = std::array<std::vector<double>, 3>;

/// Errors: kTruncated, kInvalidStream [PLN-6].
Result<PlainSteps> read_steps(ByteReader& in) {
  PlainSteps steps;
  DELTAMESH_TRY(steps.step, in.read<double>());
  if (!(steps.step >= 0 && std::isfinite(steps.step)))
    return in.invalid("a step that is not finite, or below 0", "PLN-6");
  if (steps.is_exact()) return steps;
  DELTAMESH_TRY(steps.first, in.read<std::int64_t>());
  if (steps.first < -kLargestPlainFirst || steps.first > kLargestPlainFirst)
    return in.invalid("a first number beyond 2^52", "PLN-6");
  return steps;
}

/// The component of every row, rounded to its type.
Result<void> read_component(ByteReader& in, const Attribute& shape, std::size_t component, std::uint32_t rows,
                            AttributeValues& values) {
  DELTAMESH_TRY(const PlainSteps steps, read_steps(in));
  const auto width = static_cast<unsigned>(steps.is_exact() ? 8 * component_size(shape.type) : 32);
  DELTAMESH_TRY(const auto numbers, read_differences(in, rows, width));
  values.set_component(component, [&](std::size_t i) {
    return steps.is_exact() ? numbers[i] : bits_of_number(shape.type, steps.at(numbers[i]));
  });
  return {};
}

/// The same before rounding, of a direction.
Result<std::vector<double>> read_axis(ByteReader& in, std::uint32_t rows) {
  DELTAMESH_TRY(const PlainSteps steps, read_steps(in));
  if (steps.is_exact() || steps.step > 1) return in.invalid("not a step of directions", "PLN-7");
  DELTAMESH_TRY(const auto numbers, read_differences(in, rows, 32));
  std::vector<double> axis;
  axis.reserve(numbers.size());
  for (const std::uint64_t number : numbers) axis.push_back(steps.at(number));
  return axis;
}

/// Directions of length 1, but for those of length 0.
void set_directions(const Columns& axes, AttributeValues& values) {
  for (std::size_t i = 0; i < axes[0].size(); ++i) {
    const double x = axes[0][i];
    const double y = axes[1][i];
    const double z = axes[2][i];
    const double length = std::sqrt(x * x + y * y + z * z);
    for (std::size_t c = 0; c < axes.size(); ++c)
      values.set(i, c, bits_of_number(ComponentType::kF32, length > 0 ? axes[c][i] / length : axes[c][i]));
  }
}

}  // namespace

Result<std::vector<std::byte>> read_plain_values(std::span<const std::byte> payload, const Attribute& shape,
                                                 std::uint32_t rows) {
  ByteReader in(payload, kTagAttribute);
  DELTAMESH_TRY(const auto coding, in.read<std::uint8_t>());
  const bool is_direction = coding == static_cast<std::uint8_t>(PlainCoding::kDirections);
  if (coding > static_cast<std::uint8_t>(PlainCoding::kDirections) ||
      (is_direction && (shape.type != ComponentType::kF32 || shape.components < 3)))
    return in.invalid("a coding that is not of this shape", "PLN-7");
  AttributeValues values(shape.type, shape.components, rows);
  std::size_t component = 0;
  if (is_direction) {
    Columns axes;
    for (; component < axes.size(); ++component) {
      DELTAMESH_TRY(axes[component], read_axis(in, rows));
    }
    set_directions(axes, values);
  }
  for (; component < shape.components; ++component)
    DELTAMESH_CHECK(read_component(in, shape, component, rows, values));
  DELTAMESH_CHECK(in.finish());
  return values.take();
}

}  // namespace deltamesh
