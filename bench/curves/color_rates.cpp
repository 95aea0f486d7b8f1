// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "curves/color_rates.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <numeric>
#include <optional>
#include <span>

#include "attributes/haar/picture.h"
#include "attributes/haar/writer.h"
#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "report/geometric_mean.h"
#include "report/table.h"
#include "report/text.h"
#include "support/corpus.h"
#include "support/errors.h"

namespace deltamesh::bench {
namespace {

constexpr std::array<double, 3> kDecibels = {35, 38, 41};
constexpr std::array<double, 9> kRateBounds = {1, 2, 3, 4, 6, 8, 12, 16, 24};          ///< 255ths
constexpr std::array<std::uint32_t, 9> kRateSteps = {3, 4, 6, 8, 11, 16, 22, 32, 45};  ///< levels

struct RatePoint {
  double decibels;
  std::uint64_t bytes;
};

double psnr_of_luma(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
  const auto luma = [](const std::uint8_t* c) { return 0.299 * c[0] + 0.587 * c[1] + 0.114 * c[2]; };
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); i += 3) {
    const double error = luma(&a[i]) - luma(&b[i]);
    sum += error * error;
  }
  return 10 * std::log10(255 * 255 * static_cast<double>(a.size() / 3) / sum);
}

/// Bytes at `decibels`, their logarithm being taken for a line between two points and beyond the last ones.
double bytes_at(double decibels, std::span<const RatePoint> falling) {
  std::size_t k = 0;
  while (k + 2 < falling.size() && falling[k + 1].decibels > decibels) ++k;
  const RatePoint& a = falling[k];
  const RatePoint& b = falling[k + 1];
  const double share = (decibels - a.decibels) / (b.decibels - a.decibels);
  const double first = std::log(static_cast<double>(a.bytes));
  return std::exp(first + share * (std::log(static_cast<double>(b.bytes)) - first));
}

std::vector<std::uint8_t> levels_of(std::span<const std::byte> values, std::size_t components) {
  std::vector<std::uint8_t> levels;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (i % components < 3) levels.push_back(std::to_integer<std::uint8_t>(values[i]));
  return levels;
}

/// A map's colours in coded order, and what they take at every bound and step.
struct Curves {
  std::vector<RatePoint> bounded;
  std::vector<RatePoint> transformed;
};

std::optional<Curves> curves_of(Mesh mesh) {
  std::erase_if(mesh.attributes, [](const Attribute& a) {
    return a.kind != AttributeKind::kColor || a.type != ComponentType::kU8 || a.components < 3;
  });
  if (mesh.attributes.empty()) return std::nullopt;
  mesh.attributes.resize(1);
  EncodeOptions options;
  options.effort = 0;
  options.geometry = GeometryCoder::kPredictive;
  const auto coded = [&](double bound) {
    options.attributes.color_error = bound;
    return value_or_exit(encode(mesh, options));
  };
  const Mesh exact = value_or_exit(decode(coded(0).bytes));
  const auto colors = levels_of(exact.attributes.front().values, exact.attributes.front().components);
  Curves curves;
  for (const double bound : kRateBounds) {
    const auto stream = coded(bound);
    const Mesh decoded = value_or_exit(decode(stream.bytes));
    const Attribute& attribute = decoded.attributes.front();
    curves.bounded.push_back({psnr_of_luma(colors, levels_of(attribute.values, attribute.components)),
                              stream.report.stream.attributes.front().coded_bytes});
  }
  const AttributeSurface surface(exact.triangles, static_cast<std::uint32_t>(colors.size() / 3), {},
                                 exact.positions);
  const auto levels = make_haar_levels(surface);
  std::vector<std::uint32_t> order(colors.size() / 3);
  std::iota(order.begin(), order.end(), 0U);
  const AttributeView view{.kind = AttributeKind::kColor,
                           .type = ComponentType::kU8,
                           .components = 3,
                           .name = {},
                           .values = std::as_bytes(std::span(colors))};
  const HaarWriter writer(*picture_of_colors(view.type, AttributeRows(view, order)), levels);
  for (const std::uint32_t step : kRateSteps) {
    const auto written = writer.code(64 * step, ComponentType::kU8);
    curves.transformed.push_back({psnr_of_luma(colors, levels_of(written.values, 3)), written.bytes.size()});
  }
  return curves;
}

}  // namespace

int compare_color_rates(const std::vector<std::string>& files) {
  print("Colours at equal PSNR of luma, bytes within bounds, by the transform, ratio:\n\n");
  Cells names{"mesh"};
  for (const double decibels : kDecibels)
    names.insert(names.end(), {fixed(decibels, 0) + " dB: bounds", "transform", "ratio"});
  print(table_head(names));
  std::array<GeometricMean, kDecibels.size()> means;
  for (const std::string& file : files) {
    const auto curves = curves_of(value_or_exit(load_mesh(file)));
    if (!curves) continue;
    Cells cells{std::filesystem::path(file).stem().string()};
    for (std::size_t i = 0; i < kDecibels.size(); ++i) {
      const double bounded = bytes_at(kDecibels[i], curves->bounded);
      const double transformed = bytes_at(kDecibels[i], curves->transformed);
      means[i].add(transformed / bounded);
      cells.insert(cells.end(), {fixed(bounded, 0), fixed(transformed, 0), fixed(transformed / bounded, 3)});
    }
    print(table_row(cells));
  }
  std::string text = "\nGeometric means of the ratios:";
  for (std::size_t i = 0; i < kDecibels.size(); ++i)
    text += (i > 0 ? ", " : " ") + fixed(means[i].value().value_or(0), 3) + " at " + fixed(kDecibels[i], 0) +
            " dB";
  print(text + ".\n");
  return 0;
}

}  // namespace deltamesh::bench
