// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Prints the paper's Tables 1 and 2 with our figures and writes the data of Figures 3, 6 and 7 as CSV and
// SVG.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "deltamesh/io.h"
#include "paper/paper_rows.h"
#include "paper/paper_study.h"
#include "report/svg_plot.h"

namespace {

using namespace deltamesh;
using bench::PaperPoint;
using Points = std::vector<PaperPoint>;

struct Arguments {
  std::string corpus;
  std::string out;
};

bool fail(const std::string& what, const Error& error) {
  std::fprintf(stderr, "%s: %s\n", what.c_str(), describe(error).c_str());
  return false;
}

bool write_text(const Arguments& arguments, const std::string& name, const std::string& text) {
  const std::string path = (std::filesystem::path(arguments.out) / name).string();
  const auto written = write_file(path, std::as_bytes(std::span(text)));
  return written ? true : fail(path, written.error());
}

/// Table 1: VDE, and how it falls with each bit; `zeros`: what it is without any.
void print_bits(const Points& points, const PaperPoint& zeros) {
  std::printf("| %s |", points.front().model.c_str());
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::printf(" %.4f", points[i].vde);
    if (i > 0) std::printf(" (1/%.2f)", points[i - 1].vde / points[i].vde);
    std::printf(" |");
  }
  std::printf(" %.4f |\n", zeros.vde);
}

bool print_ratio_row(const bench::WeldedMesh& mesh, const bench::PaperRow& row) {
  const auto figures = bench::measure_paper_row(mesh, row);
  if (!figures) return fail(row.model, figures.error());
  std::printf("| %s | %d | %u | %.3f | %.2f ", row.model, row.bits, row.anchors, figures->vde_over_step,
              figures->ratio);
  if (row.paper_ratio > 0) {
    std::printf("| %.1f | %.2f |\n", row.paper_ratio, figures->ratio / row.paper_ratio);
  } else {
    std::printf("| | |\n");
  }
  return true;
}

/// The points of one model as series by bits.
bench::Plot plot_of(const Points& points, const std::string& title, const std::string& x_label,
                    const std::string& y_label, const std::function<double(const PaperPoint&)>& x,
                    const std::function<double(const PaperPoint&)>& y) {
  bench::Plot plot;
  plot.title = title;
  plot.x_label = x_label;
  plot.y_label = y_label;
  for (int bits = 3; bits <= 8; ++bits) {
    bench::PlotSeries series;
    series.name = std::to_string(bits) + " bits";
    for (const PaperPoint& point : points) {
      if (point.bits != bits) continue;
      series.points.push_back({x(point), y(point)});
      series.notes.push_back(std::to_string(point.anchors) + " anchors");
    }
    std::sort(series.points.begin(), series.points.end(), [](auto a, auto b) { return a.x < b.x; });
    series.line = series.points;
    if (!series.points.empty()) plot.series.push_back(std::move(series));
  }
  return plot;
}

double share_percent(const PaperPoint& p) { return 100 * p.anchor_share; }
double density(const PaperPoint& p) { return p.density; }
double vde(const PaperPoint& p) { return p.vde; }
double lfe(const PaperPoint& p) { return p.lfe; }

bool write_figures(const Arguments& arguments, const std::string& model, const bench::WeldedMesh& mesh) {
  const auto by_anchors = bench::study_anchors(model, mesh);
  if (!by_anchors) return fail(model, by_anchors.error());
  const auto by_density = bench::study_density(model, mesh);
  if (!by_density) return fail(model, by_density.error());
  Points share = *by_density;  // the share does not depend on the bits
  std::erase_if(share, [](const PaperPoint& p) { return p.bits != 6; });
  const std::string v = "v: edges to the nearest anchor, at most";
  return write_text(arguments, "figure3_" + model + ".csv", points_csv(*by_anchors)) &&
         write_text(arguments, "figure6_" + model + ".csv", points_csv(*by_density)) &&
         write_text(arguments, "figure7_" + model + ".csv", points_csv(share)) &&
         write_text(arguments, "figure3_" + model + ".svg",
                    render_svg(plot_of(*by_anchors, model + ": VDE against anchors", "anchors, % of vertices",
                                       "S_q", share_percent, vde))) &&
         write_text(arguments, "figure6_" + model + ".svg",
                    render_svg(plot_of(*by_density, model + ": LFE against anchor density", v, "M_q", density,
                                       lfe))) &&
         write_text(arguments, "figure7_" + model + ".svg",
                    render_svg(plot_of(share, model + ": share of anchors against density", v,
                                       "anchors, % of vertices", density, share_percent)));
}

bool load(const Arguments& arguments, const std::string& model, bench::WeldedMesh& mesh) {
  auto read = bench::load_welded(arguments.corpus + "/paper/" + model + ".ply");
  if (!read) return fail(model, read.error());
  mesh = *std::move(read);
  return true;
}

bool run(const Arguments& arguments) {
  std::printf("Table 1: S_q by bits of delta, anchors at v = 10\n\n");
  std::printf("| model | 3 | 4 | 5 | 6 | 7 | 8 | all deltas 0 |\n|---|---|---|---|---|---|---|---|\n");
  bench::WeldedMesh mesh;
  Points all;
  for (const char* model :
       {"armadillo_18245", "laurana_6301", "horse_4243", "bunny_34834", "happy_buddha_49990"}) {
    if (!load(arguments, model, mesh)) return false;
    const auto points = bench::study_bits(model, mesh);
    if (!points) return fail(model, points.error());
    const auto zeros = bench::study_zeros(model, mesh);
    if (!zeros) return fail(model, zeros.error());
    print_bits(*points, *zeros);
    all.insert(all.end(), points->begin(), points->end());
  }
  std::printf(
      "\nTable 2\n\n"
      "| model | bits | anchors | S_q rms / (range 2^-p) | M_q/S_q | M_q/S_q paper | ours / paper |\n");
  std::printf("|---|---|---|---|---|---|---|\n");
  std::string_view loaded;
  for (const bench::PaperRow& row : bench::paper_rows()) {
    if (loaded != row.model && !load(arguments, row.model, mesh)) return false;
    if (!print_ratio_row(mesh, row)) return false;
    if (loaded != row.model && !arguments.out.empty() && !write_figures(arguments, row.model, mesh))
      return false;
    loaded = row.model;
  }
  return arguments.out.empty() || write_text(arguments, "table1.csv", points_csv(all));
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Tables 1 and 2 and the data of Figures 3, 6 and 7 of the paper");
  app.add_option("--corpus", arguments.corpus, "folder with paper/*.ply")->required();
  app.add_option("--out", arguments.out, "existing folder for CSV and SVG files; none are written without");
  CLI11_PARSE(app, argc, argv);
  return run(arguments) ? 0 : 1;
}
