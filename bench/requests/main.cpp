// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What is asked is what Draco reaches: our bytes over Draco's at its rms error, its largest error and its
// VDE; lossless bytes over those of zstd; times over those of Draco's quicker level; how near requests are
// met.
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "peers/measure.h"
#include "report/geometric_mean.h"
#include "report/table.h"
#include "report/text.h"
#include "requests/error_table.h"
#include "requests/quality.h"
#include "requests/rows.h"
#include "support/command_line.h"
#include "support/machine.h"
#include "support/timing.h"

namespace deltamesh::bench {
namespace {

struct Options {
  Choice choice;
  std::vector<int> bits = {10, 11, 12, 14};
  int effort = 1;
  bool times_alone = false;
  bool all = false;
};

QualityRequest same_lfe(const Quality& q) { return {.lfe = QualityBound{.value = q.lfe_rms}}; }
QualityRequest same_maximum(const Quality& q) { return {.max_error = QualityBound{q.max_error}}; }
QualityRequest same_vde(const Quality& q) { return {.vde = QualityBound{.value = q.vde_rms}}; }

constexpr Criterion kCriteria[] = {
    {"rms error", same_lfe}, {"largest error", same_maximum}, {"VDE", same_vde}};

/// Meshes that took more than Draco's bytes once are in every quick run.
bool is_quick(const std::string& name) {
  return is_quick_mesh(name) || name == "models/beetle" || name == "models/sword_quads";
}

Result<std::vector<DracoPoint>> draco_points(const Options& options, const std::string& name,
                                             const Mesh& mesh) {
  std::vector<DracoPoint> points;
  for (const int bits : options.bits) {
    const auto draco = measure(*make_draco_peer(10, bits), name, mesh);
    if (!draco) return draco.error();
    points.push_back({.bytes = draco->bytes, .quality = draco->quality});
  }
  return points;
}

/// Adds a mesh to all tables, and tells stderr how it went.
void add_mesh(const Options& options, const std::string& name, const Mesh& mesh,
              std::vector<ErrorTable>& tables) {
  const double start = processor_seconds();
  const auto points = draco_points(options, name, mesh);
  if (!points) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), points.error().message);
    return;
  }
  std::fprintf(stderr, "%s:", name.c_str());
  const auto containers = std::make_shared<AnchorContainers>();
  for (ErrorTable& table : tables) {
    std::vector<Result<RequestRow>> rows;
    for (const DracoPoint& point : *points) {
      rows.push_back(
          compare_request(mesh, table.criterion().request(point.quality), options.effort, containers));
      if (rows.back()) std::fprintf(stderr, " %.3f", ratio(rows.back()->bytes, point.bytes));
    }
    std::fprintf(stderr, ";");
    table.add(name, *points, rows);
  }
  std::fprintf(stderr, " %.0f s\n", processor_seconds() - start);
}

void print_errors(const Options& options, const std::vector<MeshSource>& sources) {
  std::vector<ErrorTable> tables;
  for (const Criterion& criterion : kCriteria) tables.emplace_back(criterion, options.bits);
  for (const MeshSource& source : sources)
    if (const auto loaded = source.load()) add_mesh(options, source.name, welded_geometry(*loaded), tables);
  print(
      "Bytes over those of Draco cl 10 at equal error; p predictive, h highpass, * where effort 0 chooses "
      "the other.\n");
  for (const ErrorTable& table : tables) print(table.markdown());
}

void print_times(const std::vector<MeshSource>& sources) {
  print("\n" + table_head({"mesh", "lossless over zstd -19", "decode ns per vertex", "Draco cl 7",
                           "encode ns per vertex, effort 0", "Draco cl 7", "default", "by VDE", "Draco cl 10",
                           "bytes per vertex", "Draco cl 7"}));
  GeometricMean decode, encode, by_default, by_vde;
  for (const MeshSource& source : sources) {
    const auto loaded = source.load();
    if (!loaded) continue;
    const Mesh mesh = welded_geometry(*loaded);
    const auto lossless = compare_lossless(mesh);
    const auto times = compare_times(mesh);
    if (!lossless || !times) {
      print(table_row({source.name, "failed"}));
      continue;
    }
    print(table_row({source.name, fixed(lossless->ratio, 3) + (lossless->exact ? "" : " NOT EXACT"),
                     fixed(times->decode_ns, 0), fixed(times->draco_decode_ns, 0), fixed(times->encode_ns, 0),
                     fixed(times->draco_encode_ns, 0), fixed(times->default_encode_ns, 0),
                     fixed(times->vde_encode_ns, 0), fixed(times->slow_draco_encode_ns, 0),
                     fixed(times->bytes_per_vertex, 3), fixed(times->draco_bytes_per_vertex, 3)}));
    decode.add(times->decode_ns / times->draco_decode_ns);
    encode.add(times->encode_ns / times->draco_encode_ns);
    by_default.add(times->default_encode_ns / times->slow_draco_encode_ns);
    by_vde.add(times->vde_encode_ns / times->slow_draco_encode_ns);
  }
  print(join({"\nGeometric means over Draco's time: decode ", fixed(decode.value().value_or(0), 2),
              ", encode ", fixed(encode.value().value_or(0), 2),
              "; encode at the default effort over level 10's: without options ",
              fixed(by_default.value().value_or(0), 2), ", by VDE ", fixed(by_vde.value().value_or(0), 2),
              ".\n"}));
}

int run(const Options& options) {
  const std::vector<MeshSource> sources = chosen_meshes(options.choice, is_quick);
  if (sources.empty()) return EXIT_FAILURE;
  print(join({"Processor ", processor_name(), ", Draco ", draco_version(), ", effort ",
              number(options.effort), ".\n"}));
  if (!options.times_alone) print_errors(options, sources);
  print_times(sources);
  return EXIT_SUCCESS;
}

int run_quality(const Options& options) {
  const auto done = print_quality(options.choice, options.all);
  if (!done) std::fprintf(stderr, "%s\n", describe(done.error()).c_str());
  return done ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace deltamesh::bench

int main(int argc, char** argv) {
  using namespace deltamesh::bench;
  Options options;
  CLI::App app("Asks deltamesh for what Draco reaches, and prints what that takes.");
  add_choice(app, options.choice, "--meshes", "Eight meshes only");
  app.add_option("--bits", options.bits, "Draco's position bits")->check(CLI::Range(4, 24));
  app.add_option("--effort", options.effort, "Of our encoder")->check(CLI::Range(0, 2));
  app.add_flag("--times", options.times_alone, "Lossless streams and times alone");
  app.fallthrough();
  auto* quality = app.add_subcommand("quality", "How near requests are met, at efforts 0 and 1");
  quality->add_flag("--all", options.all, "Instead: a largest error on every mesh file of the corpus");
  return parse_and_run(app, argc, argv, [&] { return *quality ? run_quality(options) : run(options); });
}
