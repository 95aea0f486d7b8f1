// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "paper/tables.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <vector>

#include "paper/rows.h"
#include "paper/study.h"
#include "report/files.h"
#include "report/svg_plot.h"
#include "report/table.h"
#include "report/text.h"
#include "support/errors.h"

namespace deltamesh::bench {
namespace {

constexpr const char* kModels[] = {"armadillo_18245", "laurana_6301", "horse_4243", "bunny_34834",
                                   "happy_buddha_49990"};

WeldedMesh load(const std::string& corpus, std::string_view model) {
  return value_or_exit(load_welded(join({corpus, "/paper/", model, ".ply"})));
}

std::string points_csv(const std::string& model, const PaperPoints& points) {
  std::string csv;
  for (const PaperPoint& p : points)
    csv += csv_row({model, number(p.bits), number(p.anchors), number(p.density),
                    significant(p.anchor_share, 6), significant(p.vde, 6), significant(p.lfe, 6)});
  return csv;
}

std::string csv_head() {
  return csv_row({"model", "bits", "anchors", "v", "anchor_share", "vde_paper", "lfe_paper"});
}

/// Table 1: VDE, and how it falls with each bit. `points`: the first without deltas.
std::string bits_row(const std::string& model, const PaperPoints& points) {
  Cells cells{model};
  for (std::size_t i = 1; i < points.size(); ++i) {
    cells.push_back(fixed(points[i].vde, 4));
    if (i > 1) cells.back() += join({" (1/", fixed(points[i - 1].vde / points[i].vde, 2), ")"});
  }
  cells.push_back(fixed(points.front().vde, 4));
  return table_row(cells);
}

std::string ratio_row(const PaperRow& row, const PaperPoint& point) {
  const double ratio = point.lfe / point.vde;
  Cells cells{row.model, number(row.bits), number(row.anchors), fixed(point.vde_over_step, 3),
              fixed(ratio, 2)};
  if (row.paper_ratio > 0)
    cells.insert(cells.end(), {fixed(row.paper_ratio, 1), fixed(ratio / row.paper_ratio, 2)});
  cells.resize(7);
  return table_row(cells);
}

/// A quantity of a point, as an axis has it.
struct Quantity {
  const char* label;
  double (*value)(const PaperPoint& point);
};
constexpr Quantity kShare = {"anchors, % of vertices",
                             [](const PaperPoint& p) { return 100 * p.anchor_share; }};
constexpr Quantity kDensity = {"v: edges to the nearest anchor, at most",
                               [](const PaperPoint& p) { return static_cast<double>(p.density); }};
constexpr Quantity kVde = {"S_q", [](const PaperPoint& p) { return p.vde; }};
constexpr Quantity kLfe = {"M_q", [](const PaperPoint& p) { return p.lfe; }};

/// The points of one model as series by bits.
Plot plot_of(const PaperPoints& points, const std::string& title, const Quantity& x, const Quantity& y) {
  Plot plot{.title = title, .x_label = x.label, .y_label = y.label, .footnote = {}, .series = {}};
  std::map<int, PlotSeries> by_bits;
  for (const PaperPoint& point : points) {
    PlotSeries& series = by_bits[point.bits];
    series.points.push_back({x.value(point), y.value(point)});
    series.notes.push_back(number(point.anchors) + " anchors");
  }
  for (auto& [bits, series] : by_bits) {
    series.name = number(bits) + " bits";
    std::ranges::sort(series.points, {}, &PlotPoint::x);
    series.line = series.points;
    plot.series.push_back(std::move(series));
  }
  return plot;
}

bool write_figures(const std::string& out, const std::string& model, PaperStudy& study) {
  const PaperPoints by_anchors = value_or_exit(study.by_anchors());
  const PaperPoints by_density = value_or_exit(study.by_density());
  PaperPoints share = by_density;  // the share does not depend on the bits
  std::erase_if(share, [](const PaperPoint& p) { return p.bits != 6; });
  const auto write = [&](const char* figure, const PaperPoints& points, const char* title, const Quantity& x,
                         const Quantity& y) {
    const std::string stem = join({"figure", figure, "_", model});
    return write_text(out, stem + ".csv", csv_head() + points_csv(model, points)) &&
           write_text(out, stem + ".svg", render_svg(plot_of(points, model + title, x, y)));
  };
  return write("3", by_anchors, ": VDE against anchors", kShare, kVde) &&
         write("6", by_density, ": LFE against anchor density", kDensity, kLfe) &&
         write("7", share, ": share of anchors against density", kDensity, kShare);
}

}  // namespace

int reproduce_paper(const std::string& corpus, const std::string& out) {
  print("Table 1: S_q by bits of delta, anchors at v = 10\n\n" +
        table_head({"model", "3", "4", "5", "6", "7", "8", "all deltas 0"}));
  std::string csv = csv_head();
  for (const char* model : kModels) {
    const WeldedMesh mesh = load(corpus, model);
    PaperPoints points = value_or_exit(PaperStudy(mesh).by_bits());
    print(bits_row(model, points));
    points.erase(points.begin());
    csv += points_csv(model, points);
  }
  print("\nTable 2\n\n" + table_head({"model", "bits", "anchors", "S_q rms / (range 2^-p)", "M_q/S_q",
                                      "M_q/S_q paper", "ours / paper"}));
  bool written = out.empty() || write_text(out, "table1.csv", csv);
  std::string_view loaded;
  WeldedMesh mesh;
  for (const PaperRow& row : kPaperRows) {
    const bool is_new = loaded != row.model;
    if (is_new) mesh = load(corpus, loaded = row.model);
    PaperStudy study(mesh);
    print(ratio_row(row, value_or_exit(study.code(row.bits, row.anchors))));
    if (is_new && !out.empty()) written = write_figures(out, row.model, study) && written;
  }
  return written ? 0 : 4;
}

}  // namespace deltamesh::bench
