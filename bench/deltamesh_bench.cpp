// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// deltamesh_bench: ours beside its peers on the same meshes, in one process, on one thread.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <regex>
#include <utility>

#include "peers/ladder.h"
#include "report/text.h"
#include "report/write_reports.h"
#include "run/bench_mesh.h"
#include "scenes.h"

namespace deltamesh::bench {
namespace {

constexpr std::uint64_t kGeneratedVertices = 20'000;

struct Options {
  std::string corpus;
  std::uint64_t generated = 0;  ///< vertices; 0: the corpus
  std::string meshes = ".*";
  std::string out = "bench-out";
  bool quick = false;
  int repeat = 0;  ///< 0: 3 with quick, else 5
};

std::string default_corpus() {
  const char* folder = std::getenv("DELTAMESH_CORPUS");
  return folder != nullptr ? folder : "../shared/corpus";
}

std::string check_regex(const std::string& pattern) try {
  const std::regex compiled(pattern);
  return {};
} catch (const std::regex_error&) {
  return "not a regular expression: " + pattern;
}

/// The meshes that `options` name; also says in `run` which they are.
std::vector<MeshSource> choose_meshes(const Options& options, Run& run) {
  std::vector<MeshSource> sources;
  if (options.generated == 0) sources = corpus_meshes(options.corpus);
  run.meshes = options.quick ? "six of the corpus" : "the corpus";
  if (options.quick) std::erase_if(sources, [](const MeshSource& s) { return !is_quick_mesh(s); });
  if (sources.empty()) {
    const std::uint64_t vertices = options.generated != 0 ? options.generated : kGeneratedVertices;
    run.meshes = "generated ones of about " + std::to_string(vertices) + " vertices, no corpus";
    if (options.generated == 0)
      std::fprintf(stderr, "no corpus in %s: using generated meshes\n", options.corpus.c_str());
    sources = generated_meshes(vertices);
  }
  const std::regex pattern(options.meshes);
  std::erase_if(sources, [&](const MeshSource& s) { return !std::regex_search(s.name, pattern); });
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

int run_benchmark(const Options& options) {
  Run run;
  run.timing = {.repeats = options.repeat != 0 ? options.repeat : (options.quick ? 3 : 5),
                .seconds = options.quick ? 0.25 : 2.0};
  const auto sources = choose_meshes(options, run);
  if (sources.empty()) {
    std::fprintf(stderr, "no mesh matches %s\n", options.meshes.c_str());
    return 2;
  }
  for (const MeshSource& source : sources) measure_mesh(source, options.quick, run);
  if (const auto written = write_reports(run, options.out); !written) {
    std::fprintf(stderr, "%s: %s\n", options.out.c_str(), describe(written.error()).c_str());
    return 4;
  }
  std::fprintf(stderr, "wrote %s/results.md, results.csv and plots/\n", options.out.c_str());
  return run.failures.empty() ? 0 : 1;
}

}  // namespace
}  // namespace deltamesh::bench

int main(int argc, char** argv) {
  deltamesh::bench::Options options;
  options.corpus = deltamesh::bench::default_corpus();
  CLI::App app("Compares deltamesh with its peers: size, errors and times of the same welded meshes.");
  app.add_option("--corpus", options.corpus,
                 "Folder with paper/, models/ and robot/ (default: $DELTAMESH_CORPUS)")
      ->capture_default_str();
  app.add_option("--generated", options.generated,
                 "Use generated meshes of about this many vertices instead of the corpus")
      ->check(CLI::Range(deltamesh::kMinSceneVertices, deltamesh::kMaxSceneVertices));
  app.add_option("--meshes", options.meshes, "Only meshes whose name has a match of this regular expression")
      ->check(deltamesh::bench::check_regex);
  app.add_option("--out", options.out, "Folder for results.csv, results.md and plots/")
      ->capture_default_str();
  app.add_flag("--quick", options.quick, "Six meshes, fewer settings, fewer runs: a few minutes");
  app.add_option("--repeat", options.repeat, "Most runs per time; the median counts (default: 5, quick 3)")
      ->check(CLI::Range(1, 1000));
  app.footer("Exit status: 0 all measured, 1 a peer failed (see results.md), 2 usage, 4 cannot write.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return deltamesh::bench::run_benchmark(options);
}
