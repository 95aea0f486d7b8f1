// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "colors/rate_curves.h"

#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>

#include "attributes/haar/picture.h"
#include "attributes/haar/writer.h"
#include "colors/colors_alone.h"
#include "colors/octree_levels.h"
#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "measure/colors/color_difference.h"
#include "peers/draco_mesh.h"
#include "support/errors.h"

namespace deltamesh::bench {
namespace {

constexpr std::array<double, 9> kRateBounds = {1, 2, 3, 4, 6, 8, 12, 16, 24};          ///< 255ths
constexpr std::array<std::uint32_t, 9> kRateSteps = {3, 4, 6, 8, 11, 16, 22, 32, 45};  ///< levels
constexpr std::array<unsigned, 5> kDracoColorBits = {7, 6, 5, 4, 3};
constexpr int kDracoRateLevel = 10;
constexpr int kDracoPositionBits = 11;

/// n x 3.
using Levels = std::vector<std::uint8_t>;

RatePoint rate_point(const Levels& a, const Levels& b, std::uint64_t bytes) {
  const auto luma = [](const std::uint8_t* c) { return 0.299 * c[0] + 0.587 * c[1] + 0.114 * c[2]; };
  const auto shown = [](const std::uint8_t* c) {
    return std::array<double, 3>{c[0] / 255.0, c[1] / 255.0, c[2] / 255.0};
  };
  double squares = 0;
  double differences = 0;
  for (std::size_t i = 0; i < a.size(); i += 3) {
    const double error = luma(&a[i]) - luma(&b[i]);
    squares += error * error;
    differences += color_difference(shown(&a[i]), shown(&b[i]));
  }
  const double count = static_cast<double>(a.size() / 3);
  return {.decibels = 10 * std::log10(255 * 255 * count / squares),
          .difference = differences / count,
          .bytes = bytes};
}

Levels levels_of(const Attribute& attribute) {
  Levels levels;
  for (std::size_t i = 0; i < attribute.values.size(); ++i)
    if (i % attribute.components < 3) levels.push_back(std::to_integer<std::uint8_t>(attribute.values[i]));
  return levels;
}

Encoded encode_within(const Mesh& mesh, double bound) {
  EncodeOptions options;
  options.effort = 0;
  options.geometry = GeometryCoder::kPredictive;
  options.attributes.color_error = bound;
  return value_or_exit(encode(mesh, options));
}

std::vector<RatePoint> curve_within_bounds(const Mesh& mesh, const Levels& colors) {
  std::vector<RatePoint> points;
  for (const double bound : kRateBounds) {
    const auto stream = encode_within(mesh, bound);
    const Mesh decoded = value_or_exit(decode(stream.bytes));
    points.push_back(rate_point(colors, levels_of(decoded.attributes.front()),
                                stream.report.stream.attributes.front().coded_bytes));
  }
  return points;
}

std::vector<RatePoint> curve_of_transform(const std::vector<HaarLevel>& levels, const Levels& colors) {
  std::vector<std::uint32_t> order(colors.size() / 3);
  std::iota(order.begin(), order.end(), 0U);
  const AttributeView view{.kind = AttributeKind::kColor,
                           .type = ComponentType::kU8,
                           .components = 3,
                           .name = {},
                           .values = std::as_bytes(std::span(colors))};
  const HaarWriter writer(*picture_of_colors(view.type, AttributeRows(view, order)), levels);
  std::vector<RatePoint> points;
  for (const std::uint32_t step : kRateSteps) {
    const auto written = writer.code(64 * step, ComponentType::kU8);
    const Levels values(reinterpret_cast<const std::uint8_t*>(written.values.data()),
                        reinterpret_cast<const std::uint8_t*>(written.values.data()) + written.values.size());
    points.push_back(rate_point(colors, values, written.bytes.size()));
  }
  return points;
}

/// Draco keeps integers, so its users take fewer bits of them.
std::vector<RatePoint> curve_of_draco(Mesh mesh) {
  Attribute& attribute = mesh.attributes.front();
  const std::vector<std::byte> exact = attribute.values;
  const Levels colors = levels_of(attribute);
  const auto bytes_of = [&](std::optional<std::size_t> left_out) {
    return value_or_exit(encode_draco(*to_draco(mesh, left_out), {.position_bits = kDracoPositionBits},
                                      kDracoRateLevel))
        .size();
  };
  const std::size_t without = bytes_of(0);
  std::vector<RatePoint> points;
  for (const unsigned bits : kDracoColorBits) {
    const unsigned most = (1U << bits) - 1;
    Levels shown;
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const unsigned number = (std::to_integer<unsigned>(exact[i]) * most + 127) / 255;
      attribute.values[i] = static_cast<std::byte>(number);
      if (i % attribute.components < 3)
        shown.push_back(static_cast<std::uint8_t>((number * 255 + most / 2) / most));
    }
    points.push_back(rate_point(colors, shown, bytes_of(std::nullopt) - without));
  }
  return points;
}

}  // namespace

ColorRate ColorCurves::at(ColorCoder coder, double decibels) const {
  const std::vector<RatePoint>& falling = points[static_cast<std::size_t>(coder)];
  std::size_t k = 0;
  while (k + 2 < falling.size() && falling[k + 1].decibels > decibels) ++k;
  const RatePoint& a = falling[k];
  const RatePoint& b = falling[k + 1];
  const double share = (decibels - a.decibels) / (b.decibels - a.decibels);
  const auto between = [&](double first, double second) {
    return std::exp(std::log(first) + share * (std::log(second) - std::log(first)));
  };
  return {.bytes = between(static_cast<double>(a.bytes), static_cast<double>(b.bytes)),
          .difference = between(a.difference, b.difference)};
}

std::optional<ColorCurves> measure_color_curves(Mesh loaded) {
  const auto colored = colors_alone(std::move(loaded));
  if (!colored || colored->attributes.front().components < 3) return std::nullopt;
  const Mesh& mesh = *colored;
  const Mesh coded = value_or_exit(decode(encode_within(mesh, 0).bytes));
  const Levels colors = levels_of(coded.attributes.front());
  const AttributeSurface surface(coded.triangles, static_cast<std::uint32_t>(colors.size() / 3), {},
                                 coded.positions);
  ColorCurves curves{.vertices = colors.size() / 3, .points = {}};
  const auto set = [&](ColorCoder coder, std::vector<RatePoint> points) {
    curves.points[static_cast<std::size_t>(coder)] = std::move(points);
  };
  set(ColorCoder::kBounds, curve_within_bounds(mesh, colors));
  set(ColorCoder::kTransform, curve_of_transform(make_haar_levels(surface), colors));
  set(ColorCoder::kOctree,
      curve_of_transform(make_octree_levels(surface, OctreePrediction::kFromNeighbors), colors));
  set(ColorCoder::kOctreeUnpredicted,
      curve_of_transform(make_octree_levels(surface, OctreePrediction::kNone), colors));
  set(ColorCoder::kDraco, curve_of_draco(mesh));
  return curves;
}

}  // namespace deltamesh::bench
