// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/haar/picture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "attributes/colors/fields.h"
#include "base/component.h"

namespace deltamesh {
namespace {

/// n x components, of 8 bits; empty where a value has no level.
std::optional<std::vector<std::uint8_t>> levels_of(ComponentType type, const AttributeRows& rows) {
  std::vector<std::uint8_t> levels;
  levels.reserve(rows.count() * rows.components());
  for (std::size_t i = 0; i < rows.count(); ++i) {
    for (std::size_t c = 0; c < rows.components(); ++c) {
      const auto level = nearest_color_level(type, 8, static_cast<std::uint32_t>(rows.bits(i, c)));
      if (!level) return std::nullopt;
      levels.push_back(static_cast<std::uint8_t>(*level));
    }
  }
  return levels;
}

HaarMean mean_of(const Rgb& color) noexcept {
  const HaarValue value = haar_value_of(color);
  return {static_cast<float>(value[0]), static_cast<float>(value[1]), static_cast<float>(value[2])};
}

}  // namespace

std::optional<HaarPicture> picture_of_colors(ComponentType type, const AttributeRows& rows) {
  if (!color_bits_fit(type, 8)) return std::nullopt;
  const auto levels = levels_of(type, rows);
  if (!levels) return std::nullopt;
  const std::size_t n = rows.count();
  const auto level = [&](std::size_t v, std::size_t c) { return (*levels)[v * rows.components() + c]; };
  HaarPicture picture;
  picture.components = static_cast<unsigned>(rows.components());
  bool is_grey = true;
  picture.values.resize(n);
  for (std::size_t v = 0; v < n; ++v) {
    const Rgb color{level(v, 0), level(v, 1), level(v, 2)};
    is_grey = is_grey && color[0] == color[1] && color[0] == color[2];
    picture.values[v] = mean_of(color);
  }
  picture.fields.axes = is_grey ? 1 : kHaarAxes;
  if (picture.components == kHaarAxes) return picture;
  const std::uint8_t first = n > 0 ? level(0, kHaarAxes) : std::uint8_t{0};
  bool is_constant = true;
  for (std::size_t v = 0; v < n && is_constant; ++v) is_constant = level(v, kHaarAxes) == first;
  picture.fields.alpha = is_constant ? HaarAlpha::kConstant : HaarAlpha::kCoded;
  if (is_constant) {
    picture.fields.alpha_level = first;
    return picture;
  }
  picture.alpha.resize(n);
  for (std::size_t v = 0; v < n; ++v) {
    const std::uint8_t alpha = level(v, kHaarAxes);
    picture.alpha[v] = mean_of({alpha, alpha, alpha});
  }
  return picture;
}

std::optional<HaarPicture> picture_of_numbers(ComponentType type, const AttributeRows& rows) {
  const std::size_t n = rows.count();
  std::vector<double> numbers(n);
  for (std::size_t v = 0; v < n; ++v) numbers[v] = load_component(type, rows.row(v));
  if (!std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); }))
    return std::nullopt;
  if (n == 0) return std::nullopt;
  const auto [least, most] = std::minmax_element(numbers.begin(), numbers.end());
  HaarPicture picture;
  picture.components = 1;
  HaarScale& scale = picture.fields.scale;
  scale = {.low = static_cast<float>(*least), .unit = static_cast<float>((*most - *least) / 255)};
  if (!scale.is_valid()) return std::nullopt;
  picture.fields.axes = 1;
  picture.values.resize(n);
  for (std::size_t v = 0; v < n; ++v)
    picture.values[v] = {static_cast<float>((numbers[v] - scale.low) * (1 << kHaarUnitBits) / scale.unit), 0,
                         0};
  return picture;
}

}  // namespace deltamesh
