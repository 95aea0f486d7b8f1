// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "colors/rates.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>

#include "colors/rate_curves.h"
#include "report/files.h"
#include "report/geometric_mean.h"
#include "report/svg_plot.h"
#include "report/table.h"
#include "report/text.h"
#include "support/corpus.h"
#include "support/errors.h"

namespace deltamesh::bench {
namespace {

constexpr std::array<double, 3> kDecibels = {35, 38, 41};
constexpr std::size_t kCoders = kColorCoderNames.size();

/// `error`: of a point, what the plot goes upwards by.
template <class ErrorOf>
Plot rate_plot(const std::string& mesh, const ColorCurves& curves, const std::string& y_label,
               ErrorOf error) {
  Plot plot{.title = mesh + ": colours",
            .x_label = "bits per vertex, colours alone",
            .y_label = y_label,
            .footnote = {},
            .series = {}};
  for (std::size_t c = 0; c < kCoders; ++c) {
    PlotSeries series{.name = std::string(kColorCoderNames[c]), .points = {}, .line = {}, .notes = {}};
    for (const RatePoint& point : curves.points[c]) {
      series.points.push_back(
          {.x = 8 * static_cast<double>(point.bytes) / static_cast<double>(curves.vertices),
           .y = error(point)});
      series.notes.push_back(fixed(point.decibels, 1) + " dB");
    }
    series.line = series.points;
    plot.series.push_back(std::move(series));
  }
  return plot;
}

bool write_plots(const std::string& folder, const std::string& mesh, const ColorCurves& curves) {
  const auto luma = [](const RatePoint& point) { return 255 * std::pow(10, -point.decibels / 20); };
  const auto seen = [](const RatePoint& point) { return point.difference; };
  return write_text(folder, "colors." + mesh + ".luma.svg",
                    render_svg(rate_plot(mesh, curves, "luma's error (rms), 255ths", luma))) &&
         write_text(folder, "colors." + mesh + ".ciede2000.svg",
                    render_svg(rate_plot(mesh, curves, "mean CIEDE2000", seen)));
}

}  // namespace

int compare_color_rates(const std::vector<std::string>& files, const std::string& out) {
  print(
      "Colours at equal PSNR of luma: bytes within bounds, the others' over them, mean CIEDE2000 of "
      "two:\n\n");
  Cells names{"mesh", "dB"};
  for (const std::string_view name : kColorCoderNames) names.emplace_back(name);
  names.insert(names.end(), {"CIEDE2000 within bounds", "by the transform"});
  print(table_head(names));
  std::array<std::array<GeometricMean, kCoders>, kDecibels.size()> means;
  for (const std::string& file : files) {
    const auto curves = measure_color_curves(value_or_exit(load_mesh(file)));
    if (!curves) continue;
    const std::string mesh = std::filesystem::path(file).stem().string();
    if (!out.empty() && !write_plots(out, mesh, *curves)) return 4;
    for (std::size_t i = 0; i < kDecibels.size(); ++i) {
      const ColorRate bounded = curves->at(ColorCoder::kBounds, kDecibels[i]);
      Cells cells{mesh, fixed(kDecibels[i], 0), fixed(bounded.bytes, 0)};
      for (std::size_t c = 1; c < kCoders; ++c) {
        const double share = curves->at(static_cast<ColorCoder>(c), kDecibels[i]).bytes / bounded.bytes;
        means[i][c].add(share);
        cells.push_back(fixed(share, 3));
      }
      const ColorRate transformed = curves->at(ColorCoder::kTransform, kDecibels[i]);
      cells.insert(cells.end(), {fixed(bounded.difference, 2), fixed(transformed.difference, 2)});
      print(table_row(cells));
    }
  }
  for (std::size_t i = 0; i < kDecibels.size(); ++i) {
    Cells cells{"geometric mean", fixed(kDecibels[i], 0), ""};
    for (std::size_t c = 1; c < kCoders; ++c) cells.push_back(fixed(means[i][c].value().value_or(0), 3));
    cells.insert(cells.end(), {"", ""});
    print(table_row(cells));
  }
  return 0;
}

}  // namespace deltamesh::bench
