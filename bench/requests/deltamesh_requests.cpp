// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What is asked is what Draco reaches: our bytes over Draco's at its rms error, its largest error and its
// VDE; lossless bytes over those of zstd; decode times over those of Draco's quicker level.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <regex>
#include <string>
#include <vector>

#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "peers/peer.h"
#include "report/geometric_mean.h"
#include "requests/request_rows.h"
#include "run/bench_mesh.h"
#include "run/machine.h"
#include "run/measure.h"

namespace deltamesh::bench {
namespace {

struct Options {
  std::string corpus;
  std::string meshes = ".";
  std::vector<int> bits = {10, 11, 12, 14};
  int effort = 5;
};

/// One column: a request made of what Draco reached.
struct Column {
  const char* name;
  QualityRequest (*request)(const Quality&);
  std::vector<GeometricMean> means;
};

QualityRequest same_lfe(const Quality& q) { return {.lfe = QualityBound{.value = q.lfe_rms}}; }
QualityRequest same_maximum(const Quality& q) { return {.max_error = q.max_error}; }
QualityRequest same_vde(const Quality& q) { return {.vde = QualityBound{.value = q.vde_rms}}; }

void print_ratios(const Options& options, const MeshSource& source, const Mesh& mesh, Column& column) {
  std::printf("| %s | %s |", source.name.c_str(), column.name);
  for (std::size_t i = 0; i < options.bits.size(); ++i) {
    const auto peer = make_draco_peer(10, options.bits[i]);
    const auto draco = measure(*peer, source.name, mesh, {.repeats = 1, .seconds = 0});
    const auto row =
        draco ? compare_request(mesh, column.request(draco->quality), options.effort) : draco.error();
    if (!row) {
      std::printf(" %s |", row.error().message);
      continue;
    }
    const double ratio = static_cast<double>(row->bytes) / static_cast<double>(draco->bytes);
    column.means[i].add(ratio);
    std::printf(" %.3f %s%s%s |", ratio, row->geometry == "predictive" ? "p" : "h",
                row->agrees_at_effort_0 ? "" : "*", row->kept ? "" : " EXCEEDED");
  }
  std::printf("\n");
  std::fflush(stdout);
}

void print_lossless_and_time(const MeshSource& source, const Mesh& mesh) {
  const auto lossless = compare_lossless(mesh);
  const auto times = compare_times(mesh);
  if (!lossless || !times) {
    std::printf("| %s | failed |\n", source.name.c_str());
    return;
  }
  std::printf("| %s | %.3f%s | %.0f | %.0f | %.0f | %.0f |\n", source.name.c_str(), lossless->ratio,
              lossless->exact ? "" : " NOT EXACT", times->decode_ns, times->draco_decode_ns, times->encode_ns,
              times->draco_encode_ns);
  std::fflush(stdout);
}

int run(const Options& options) {
  const std::regex wanted(options.meshes);
  std::vector<MeshSource> sources;
  for (const MeshSource& source : corpus_meshes(options.corpus))
    if (std::regex_search(source.name, wanted)) sources.push_back(source);
  const std::vector<GeometricMean> fresh(options.bits.size());
  Column columns[] = {{"rms", same_lfe, fresh}, {"maximum", same_maximum, fresh}, {"VDE", same_vde, fresh}};

  std::printf(
      "Processor %s, Draco %s, effort %d. Bytes over those of Draco cl 10 at equal error; p predictive, ",
      processor_name().c_str(), draco_version().c_str(), options.effort);
  std::printf("h highpass, * where effort 0 chooses the other.\n\n| mesh | error |");
  for (const int bits : options.bits) std::printf(" qp %d |", bits);
  std::printf("\n");
  for (const MeshSource& source : sources) {
    const auto loaded = source.load();
    if (!loaded) continue;
    const Mesh mesh = welded_geometry(*loaded);
    for (Column& column : columns) print_ratios(options, source, mesh, column);
  }
  for (const Column& column : columns) {
    std::printf("| geometric mean | %s |", column.name);
    for (const GeometricMean& mean : column.means) std::printf(" %.3f |", mean.value().value_or(0));
    std::printf("\n");
  }
  std::printf(
      "\n| mesh | lossless over zstd -19 | decode ns per vertex | Draco cl 7 | encode, effort 0 | Draco cl 7 "
      "|\n");
  for (const MeshSource& source : sources) {
    if (const auto loaded = source.load()) print_lossless_and_time(source, welded_geometry(*loaded));
  }
  return 0;
}

}  // namespace
}  // namespace deltamesh::bench

int main(int argc, char** argv) {
  deltamesh::bench::Options options;
  const char* corpus = std::getenv("DELTAMESH_CORPUS");
  options.corpus = corpus != nullptr ? corpus : "../shared/corpus";
  CLI::App app("Asks deltamesh for what Draco reaches, and prints what that takes.");
  app.add_option("--corpus", options.corpus, "Folder with paper/, models/ and robot/")->capture_default_str();
  app.add_option("--meshes", options.meshes, "Only meshes whose name has a match of this regular expression");
  app.add_option("--bits", options.bits, "Draco's position bits")->check(CLI::Range(4, 24));
  app.add_option("--effort", options.effort, "Of our encoder")->check(CLI::Range(0, 9));
  CLI11_PARSE(app, argc, argv);
  return deltamesh::bench::run(options);
}
