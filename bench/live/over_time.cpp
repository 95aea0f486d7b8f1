// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "live/over_time.h"

#include <algorithm>
#include <array>

#include "report/files.h"
#include "report/svg_plot.h"
#include "report/table.h"
#include "report/text.h"

namespace deltamesh::bench {
namespace {

constexpr std::size_t kMostSeries = 6;

struct Figure {
  const char* slug;
  const char* label;
  double (*of)(const LiveSample&);
  double least;  ///< drawn in place of less, as plots are logarithmic
};
constexpr std::array kFigures{
    Figure{"age", "age of the oldest part, s", [](const LiveSample& s) { return s.age; }, 0.05},
    Figure{"error", "root mean square error, voxels", [](const LiveSample& s) { return s.error; }, 0.01},
    Figure{"bytes", "kB to the receiver",
           [](const LiveSample& s) { return static_cast<double>(s.bytes) / 1e3; }, 0.1},
};

std::string round_trip_of(const LiveSettings& settings) { return fixed(2e3 * settings.link.delay, 0); }

}  // namespace

void OverTime::add(const std::string& sequence, const LiveSettings& settings, const LiveResult& result) {
  runs_.push_back({sequence, settings, result.samples});
}

bool OverTime::write(const std::string& folder) const {
  std::string csv = csv_row({"sequence", "round_trip_ms", "loss_percent", "seed", "seconds", "bytes",
                             "parts_behind", "age_s", "error_voxels"});
  bool is_written = true;
  for (const Run& run : runs_) {
    for (const LiveSample& s : run.samples)
      csv += csv_row({quoted(run.sequence), round_trip_of(run.settings),
                      fixed(100 * run.settings.link.loss, 1), number(run.settings.seed), fixed(s.seconds, 3),
                      number(s.bytes), number(s.behind), fixed(s.age, 3), fixed(s.error, 4)});
    if (run.settings.link.loss == 0) is_written = write_plots(folder, run) && is_written;
  }
  return write_text(folder, "over_time.csv", csv) && is_written;
}

bool OverTime::write_plots(const std::string& folder, const Run& first) const {
  bool is_written = true;
  const std::string round_trip = round_trip_of(first.settings);
  for (const Figure& figure : kFigures) {
    Plot plot{.title = join({first.sequence, ", round trip ", round_trip, " ms"}),
              .x_label = "seconds",
              .y_label = figure.label,
              .footnote = join({"less than ", fixed(figure.least, 2), " is drawn as that"}),
              .series = {}};
    for (const Run& run : runs_) {
      if (run.sequence != first.sequence || run.settings.link.delay != first.settings.link.delay ||
          run.settings.seed != first.settings.seed || plot.series.size() == kMostSeries)
        continue;
      PlotSeries& series = plot.series.emplace_back();
      series.name = join({"loss ", fixed(100 * run.settings.link.loss, 0), " %"});
      for (const LiveSample& s : run.samples)
        if (s.seconds > 0) series.line.push_back({s.seconds, std::max(figure.of(s), figure.least)});
    }
    is_written = write_text(folder, join({first.sequence, ".", round_trip, "ms.", figure.slug, ".svg"}),
                            render_svg(plot)) &&
                 is_written;
  }
  return is_written;
}

}  // namespace deltamesh::bench
