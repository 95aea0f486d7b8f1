// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// deltamesh_bench: ours beside its peers on the same meshes, in one process, on one thread.
#include <algorithm>
#include <cstdio>
#include <utility>

#include "colors/bounds.h"
#include "colors/rates.h"
#include "colors/wholes.h"
#include "curves/ladder.h"
#include "curves/rate_distortion.h"
#include "curves/report.h"
#include "paper/tables.h"
#include "report/files.h"
#include "report/text.h"
#include "scenes.h"
#include "support/command_line.h"

namespace deltamesh::bench {
namespace {

constexpr std::uint64_t kGeneratedVertices = 20'000;

struct Options {
  Choice choice;
  std::uint64_t generated = 0;  ///< vertices; 0: the corpus
  std::string out;              ///< empty: the default, or none
  int repeat = 0;               ///< 0: 3 with quick, else 5
  std::vector<std::string> files;
};

/// The meshes that `options` name; also says in `run` which they are.
std::vector<MeshSource> choose_meshes(const Options& options, Run& run) {
  Choice choice = options.choice;
  std::vector<MeshSource> sources;
  if (options.generated == 0) sources = corpus_meshes(choice.corpus);
  run.meshes = choice.quick ? "six of the corpus" : "the corpus";
  if (sources.empty()) {
    const std::uint64_t vertices = options.generated != 0 ? options.generated : kGeneratedVertices;
    run.meshes = "generated ones of about " + number(vertices) + " vertices, no corpus";
    if (options.generated == 0)
      std::fprintf(stderr, "no corpus in %s: using generated meshes\n", choice.corpus.c_str());
    sources = generated_meshes(vertices);
    choice.quick = false;
  }
  keep_chosen(sources, choice, is_quick_mesh);
  return sources;
}

void measure_mesh(const MeshSource& source, bool quick, Run& run) {
  const auto fail = [&](const std::string& peer, const Error& error) {
    run.failures.push_back({.mesh = source.name, .peer = peer, .reason = describe(error)});
    std::fprintf(stderr, "%s %s: failed: %s\n", source.name.c_str(), peer.c_str(), describe(error).c_str());
  };
  const auto loaded = source.load();
  if (!loaded) return fail("", loaded.error());
  const Mesh mesh = welded_geometry(*loaded);
  for (const auto& peer : make_ladder(quick)) {
    const std::string label = peer->name() + " " + peer->setting();
    const auto measured = measure(*peer, source.name, mesh, run.timing);
    if (!measured) {
      fail(label, measured.error());
      continue;
    }
    run.measurements.push_back(*measured);
    std::fprintf(stderr, "%-26s %-22s %7s bits/vertex  VDE %9s %%  LFE %9s %%\n", source.name.c_str(),
                 label.c_str(), fixed(measured->bits_per_vertex(), 3).c_str(),
                 significant(measured->percent(measured->quality.vde_rms), 4).c_str(),
                 significant(measured->percent(measured->quality.lfe_rms), 4).c_str());
  }
}

/// results.csv, results.md and, for every mesh and kind of error, plots/<mesh>.<kind>.svg, '/' as '-'.
bool write_reports(const Run& run, const std::string& folder) {
  bool written = write_text(folder, "results.csv", render_csv(run)) &&
                 write_text(folder, "results.md", render_markdown(run));
  for (const std::string& mesh : mesh_names(run)) {
    std::string stem = mesh;
    std::replace(stem.begin(), stem.end(), '/', '-');
    for (const ErrorKind& kind : kErrorKinds)
      if (const auto plot = rate_distortion_plot(run, mesh, kind))
        written =
            written && write_text(folder, "plots/" + stem + "." + kind.slug + ".svg", render_svg(*plot));
  }
  return written;
}

int compare_peers(const Options& options) {
  Run run;
  const bool quick = options.choice.quick;
  run.timing = {.rounds = options.repeat != 0 ? options.repeat : (quick ? 3 : 5),
                .seconds = quick ? 0.25 : 2.0};
  const auto sources = choose_meshes(options, run);
  if (sources.empty()) {
    std::fprintf(stderr, "no mesh matches %s\n", options.choice.names.c_str());
    return 2;
  }
  for (const MeshSource& source : sources) measure_mesh(source, quick, run);
  const std::string out = options.out.empty() ? "bench-out" : options.out;
  if (!write_reports(run, out)) return 4;
  std::fprintf(stderr, "wrote %s/results.md, results.csv and plots/\n", out.c_str());
  return run.failures.empty() ? 0 : 1;
}

}  // namespace
}  // namespace deltamesh::bench

int main(int argc, char** argv) {
  using namespace deltamesh::bench;
  Options options;
  CLI::App app("Compares deltamesh with its peers: size, errors and times of the same welded meshes.");
  add_choice(app, options.choice, "--meshes", "Six meshes, fewer settings, fewer runs: a few minutes");
  app.add_option("--generated", options.generated,
                 "Use generated meshes of about this many vertices instead of the corpus")
      ->check(CLI::Range(deltamesh::kMinSceneVertices, deltamesh::kMaxSceneVertices));
  app.add_option("--out", options.out,
                 "Folder for results.csv, results.md and plots/ (default: bench-out), or for plots of "
                 "colours (default: none)");
  app.add_option("--repeat", options.repeat, "Most runs per time; the median counts (default: 5, quick 3)")
      ->check(CLI::Range(1, 1000));
  app.footer("Exit status: 0 all measured, 1 a peer failed (see results.md), 2 usage, 4 cannot write.");
  app.fallthrough();
  auto* colors = app.add_subcommand("colors", "Bytes of colours beside Draco, exact and within bounds");
  colors->add_option("files", options.files, "Meshes with 8-bit colours")->required();
  bool rates = false;
  auto* at_rates = colors->add_flag("--rates", rates,
                                    "At equal PSNR of luma: within bounds, by transforms over the mesh and "
                                    "an octree, Draco; plots in --out");
  bool whole = false;
  colors->add_flag("--whole", whole, "Whole meshes with their colours by default: bytes and times")
      ->excludes(at_rates);
  auto* paper = app.add_subcommand(
      "paper", "Tables 1 and 2 of the paper; the data of Figures 3, 6 and 7 as CSV and SVG in --out");
  return parse_and_run(app, argc, argv, [&] {
    if (*colors && whole) return compare_whole_meshes(options.files);
    if (*colors)
      return rates ? compare_color_rates(options.files, options.out) : compare_colors(options.files);
    if (*paper) return reproduce_paper(options.choice.corpus, options.out);
    return compare_peers(options);
  });
}
