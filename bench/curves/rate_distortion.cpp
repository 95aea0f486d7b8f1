// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "curves/rate_distortion.h"

#include <algorithm>
#include <utility>

#include "curves/hull.h"
#include "curves/ladder.h"
#include "report/text.h"

namespace deltamesh::bench {
namespace {

PlotSeries peer_series(const Run& run, const std::string& mesh, const std::string& peer,
                       const ErrorKind& kind) {
  PlotSeries series{.name = peer, .points = {}, .line = {}, .notes = {}};
  std::vector<CurvePoint> curve;
  for (const Measurement& m : run.measurements) {
    if (m.mesh != mesh || m.peer != peer || !(kind.percent(m) > 0)) continue;
    series.points.push_back({.x = m.bits_per_vertex(), .y = kind.percent(m)});
    series.notes.push_back(m.setting);
    curve.push_back({.error = kind.percent(m), .bytes = m.bits_per_vertex()});
  }
  for (const CurvePoint& point : lower_hull(curve))
    series.line.push_back({.x = point.bytes, .y = point.error});
  return series;
}

/// Smallest and largest size.
std::pair<double, double> size_range(const PlotSeries& series) {
  const auto [low, high] =
      std::minmax_element(series.points.begin(), series.points.end(),
                          [](const PlotPoint& a, const PlotPoint& b) { return a.x < b.x; });
  return {low->x, high->x};
}

/// Takes the peers that are too large to be shown beside ours out of the plot and into its footnote.
void drop_far_peers(Plot& plot) {
  constexpr double kFar = 1.5;
  const auto ours = std::find_if(plot.series.begin(), plot.series.end(),
                                 [](const PlotSeries& series) { return series.name == kOurName; });
  if (ours == plot.series.end()) return;
  const double limit = kFar * size_range(*ours).second;
  for (const PlotSeries& series : plot.series) {
    const auto [low, high] = size_range(series);
    if (low <= limit) continue;
    plot.footnote += join({plot.footnote.empty() ? "Beyond the right edge: " : "; ", series.name, " at ",
                           fixed(low, 1), " to ", fixed(high, 1), " bits per vertex"});
  }
  std::erase_if(plot.series, [&](const PlotSeries& series) { return size_range(series).first > limit; });
}

}  // namespace

std::optional<Plot> rate_distortion_plot(const Run& run, const std::string& mesh, const ErrorKind& kind) {
  Plot plot{.title = mesh + ": " + kind.name + " against size",
            .x_label = "bits per vertex, connectivity included",
            .y_label = std::string(kind.name) + " (rms), % of the bounding box's diagonal",
            .footnote = {},
            .series = {}};
  for (const std::string& peer : peer_names(run)) {
    PlotSeries series = peer_series(run, mesh, peer, kind);
    if (!series.points.empty()) plot.series.push_back(std::move(series));
  }
  if (plot.series.empty()) return std::nullopt;
  drop_far_peers(plot);
  return plot;
}

}  // namespace deltamesh::bench
