// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What is asked is what Draco reaches: our bytes over Draco's at its rms error, its largest error and its
// VDE; lossless bytes over those of zstd; decode times over those of Draco's quicker level.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <regex>
#include <string>
#include <vector>

#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "peers/peer.h"
#include "report/geometric_mean.h"
#include "requests/acceptance_table.h"
#include "requests/request_rows.h"
#include "run/bench_mesh.h"
#include "run/machine.h"
#include "run/measure.h"
#include "support/processor_seconds.h"

namespace deltamesh::bench {
namespace {

struct Options {
  std::string corpus;
  std::string meshes = ".";
  std::vector<int> bits = {10, 11, 12, 14};
  int effort = 5;
  bool quick = false;
  bool times_alone = false;
};

QualityRequest same_lfe(const Quality& q) { return {.lfe = QualityBound{.value = q.lfe_rms}}; }
QualityRequest same_maximum(const Quality& q) { return {.max_error = QualityBound{q.max_error}}; }
QualityRequest same_vde(const Quality& q) { return {.vde = QualityBound{.value = q.vde_rms}}; }

constexpr Criterion kCriteria[] = {
    {.name = "rms error", .request = same_lfe, .most_mean = 0.85, .most_single = 1.00, .most_map = 0.62},
    {.name = "largest error",
     .request = same_maximum,
     .most_mean = 0.88,
     .most_single = 1.02,
     .most_map = {}},
    {.name = "VDE", .request = same_vde, .most_mean = 0.68, .most_single = 1.00, .most_map = {}}};

/// Meshes that took more than Draco's bytes once are in every quick run.
bool is_hard_mesh(const MeshSource& source) {
  return source.name == "models/beetle" || source.name == "models/sword_quads";
}

std::vector<MeshSource> chosen_meshes(const Options& options) {
  const std::regex wanted(options.meshes);
  std::vector<MeshSource> sources;
  for (const MeshSource& source : corpus_meshes(options.corpus)) {
    if (!std::regex_search(source.name, wanted)) continue;
    if (!options.quick || is_quick_mesh(source) || is_hard_mesh(source)) sources.push_back(source);
  }
  return sources;
}

Result<std::vector<DracoPoint>> draco_points(const Options& options, const MeshSource& source,
                                             const Mesh& mesh) {
  std::vector<DracoPoint> points;
  for (const int bits : options.bits) {
    const auto peer = make_draco_peer(10, bits);
    const auto draco = measure(*peer, source.name, mesh, {.repeats = 1, .seconds = 0});
    if (!draco) return draco.error();
    points.push_back({.bytes = draco->bytes, .quality = draco->quality});
  }
  return points;
}

/// Adds a mesh to all tables, and tells stderr how it went.
void add_mesh(const Options& options, const MeshSource& source, const Mesh& mesh,
              std::vector<AcceptanceTable>& tables) {
  const double start = processor_seconds();
  const auto points = draco_points(options, source, mesh);
  if (!points) {
    std::fprintf(stderr, "%s: %s\n", source.name.c_str(), points.error().message);
    return;
  }
  std::fprintf(stderr, "%s:", source.name.c_str());
  const auto containers = std::make_shared<AnchorContainers>();
  for (AcceptanceTable& table : tables) {
    std::vector<Result<RequestRow>> rows;
    for (const DracoPoint& point : *points) {
      rows.push_back(
          compare_request(mesh, table.criterion().request(point.quality), options.effort, containers));
      if (rows.back())
        std::fprintf(stderr, " %.3f",
                     static_cast<double>(rows.back()->bytes) / static_cast<double>(point.bytes));
    }
    std::fprintf(stderr, ";");
    table.add(source.name, *points, rows);
  }
  std::fprintf(stderr, " %.0f s\n", processor_seconds() - start);
}

/// Our time over Draco's, over meshes.
struct Race {
  GeometricMean ratio;
  int meshes = 0;
  int at_least_as_fast = 0;

  void add(double ours, double draco) {
    ratio.add(ours / draco);
    ++meshes;
    at_least_as_fast += ours <= draco ? 1 : 0;
  }
  void print(const char* name) const {
    if (const auto mean = ratio.value())
      std::printf("%s: geometric mean %.2f of Draco's time; %d of %d meshes at least as fast.\n", name, *mean,
                  at_least_as_fast, meshes);
  }
};

struct Races {
  Race decode;
  Race encode;
};

void print_lossless_and_time(const MeshSource& source, const Mesh& mesh, Races& races) {
  const auto lossless = compare_lossless(mesh);
  const auto times = compare_times(mesh);
  if (!lossless || !times) {
    std::printf("| %s | failed |\n", source.name.c_str());
    return;
  }
  std::printf("| %s | %.3f%s | %.0f | %.0f | %.0f | %.0f | %d | %.3f | %.3f |\n", source.name.c_str(),
              lossless->ratio, lossless->exact ? "" : " NOT EXACT", times->decode_ns, times->draco_decode_ns,
              times->encode_ns, times->draco_encode_ns, times->effort, times->bytes_per_vertex,
              times->draco_bytes_per_vertex);
  std::fflush(stdout);
  races.decode.add(times->decode_ns, times->draco_decode_ns);
  races.encode.add(times->encode_ns, times->draco_encode_ns);
}

void print_acceptance(const Options& options, const std::vector<MeshSource>& sources) {
  std::vector<AcceptanceTable> tables;
  for (const Criterion& criterion : kCriteria) tables.emplace_back(criterion, options.bits);
  for (const MeshSource& source : sources)
    if (const auto loaded = source.load()) add_mesh(options, source, welded_geometry(*loaded), tables);
  std::printf(
      "Bytes over those of Draco cl 10 at equal error; p predictive, h highpass, * where effort 0 chooses "
      "the other.\n");
  for (const AcceptanceTable& table : tables) table.print();
}

int run(const Options& options) {
  const std::vector<MeshSource> sources = chosen_meshes(options);
  if (sources.empty()) {
    std::fprintf(stderr, "%s: no mesh whose name matches %s\n", options.corpus.c_str(),
                 options.meshes.c_str());
    return EXIT_FAILURE;
  }
  std::printf("Processor %s, Draco %s, effort %d.\n", processor_name().c_str(), draco_version().c_str(),
              options.effort);
  if (!options.times_alone) print_acceptance(options, sources);
  std::printf(
      "\n| mesh | lossless over zstd -19 | decode ns per vertex | Draco cl 7 | encode ns per vertex | Draco "
      "cl 7 "
      "| at effort | bytes per vertex | Draco cl 7 |\n|---|---|---|---|---|---|---|---|---|\n");
  Races races;
  for (const MeshSource& source : sources) {
    if (const auto loaded = source.load()) print_lossless_and_time(source, welded_geometry(*loaded), races);
  }
  std::printf("\n");
  races.decode.print("Decode");
  races.encode.print("Encode");
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
  app.add_flag("--quick", options.quick, "Eight meshes only");
  app.add_flag("--times", options.times_alone, "Lossless streams and times alone");
  CLI11_PARSE(app, argc, argv);
  return deltamesh::bench::run(options);
}
