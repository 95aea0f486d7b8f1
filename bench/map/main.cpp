// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Updates of maps: bytes and times beside raw triangles, Draco block by block and our own streams block by
// block; and what need not be sent as it is good enough. Whole maps in parts: bytes beside one stream.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "map/exchange.h"
#include "map/peers.h"
#include "map/splits.h"
#include "map/updates.h"
#include "report/table.h"
#include "report/text.h"
#include "support/command_line.h"
#include "support/errors.h"
#include "support/timing.h"

namespace deltamesh::bench {
namespace {

constexpr double kMaxError = 0.05;  // voxels
constexpr double kCoarse = 0.25;    // voxels, where older versions may stay

struct Settings {
  ExchangeSettings exchange;
  int effort = 0;
  double color_psnr = 0;
  int rounds = 3;
  std::vector<double> part_edges = {8, 4, 2, 1};
  std::vector<std::string> folders;
  std::string wholes;
  std::array<double, 3> origin{};
  std::vector<std::string> splits;
  double voxel = 0.04;
  std::uint64_t vertices = 50'000;
  std::uint32_t steps = 20;
};

template <class Code>
Sums run_blocks(const MapUpdates& updates, const Bounds& bounds, Code code) {
  Sums sums;
  for (const SequenceStep& step : updates.steps) {
    for (const SequenceBlock& block : step.changed) {
      const CodedBlock coded = code(block.mesh, bounds);
      sums.bytes += coded.bytes;
      sums.encode += coded.encode_seconds;
      sums.decode += coded.decode_seconds;
      ++sums.sent;
    }
  }
  return sums;
}

Bounds bounds_of(const Settings& settings, double max_error) {
  Bounds bounds{.max_error = max_error, .effort = settings.effort};
  if (settings.color_psnr > 0) bounds.color_rms = 255 * std::pow(10, -settings.color_psnr / 20);
  return bounds;
}

/// Medians of rounds in which Draco and the map take turns.
Cells time_cells(const MapUpdates& updates, const Bounds& bounds, const Settings& settings) {
  const double scale = 1e3 / static_cast<double>(updates.steps.size());
  std::vector<double> encode, decode, join, largest, map_all, draco_all;
  for (int i = 0; i < settings.rounds; ++i) {
    const Sums draco = run_blocks(updates, bounds, draco_block);
    const Sums map = run_map(updates, bounds, {.most_triangles = settings.exchange.most_triangles});
    encode.push_back(scale * map.encode);
    decode.push_back(scale * map.decode);
    join.push_back(scale * map.join);
    largest.push_back(1e3 * map.largest_update);
    map_all.push_back(map.encode + map.decode + map.join);
    draco_all.push_back(draco.encode + draco.decode);
  }
  return {fixed(median(encode), 1), fixed(median(decode), 1), fixed(median(join), 1),
          fixed(median(largest), 1), fixed(median_ratio(map_all, draco_all), 2)};
}

/// What may stay as it is good enough, and how good it is.
void print_coarse(const MapUpdates& updates, const Bounds& bounds, const Settings& settings,
                  double fine_error) {
  ExchangeSettings exchange{.most_triangles = settings.exchange.most_triangles, .keeps_good_enough = false};
  const Sums all = run_map(updates, bounds, exchange);
  const Sums some = run_map(updates, bounds, settings.exchange);
  std::string text = join({"  at ", fixed(kCoarse, 2), " voxel: bytes of sending every changed part ",
                           fixed(ratio(some.bytes, all.bytes), 3), ", parts kept as good enough ",
                           fixed(ratio(some.kept, some.kept + some.sent), 3)});
  if (settings.exchange.measures)
    text +=
        join({"; largest errors at the receiver, voxels: ", fixed(fine_error, 4), " of ", fixed(kMaxError, 2),
              ", ", fixed(some.largest_error / updates.voxel, 4), " of ", fixed(kCoarse, 2)});
  print(text + "\n");
}

void run_updates(const MapUpdates& updates, const Settings& settings) {
  const auto count = static_cast<double>(updates.steps.size());
  Bounds bounds = bounds_of(settings, kMaxError * updates.voxel);
  std::uint64_t raw = 0;
  for (const SequenceStep& step : updates.steps)
    for (const SequenceBlock& block : step.changed) raw += raw_bytes(block.mesh);
  const Sums map = run_map(updates, bounds, settings.exchange);
  const Sums draco = run_blocks(updates, bounds, draco_block);
  const Sums plain = run_blocks(updates, bounds, plain_block);
  Cells cells{updates.name,
              number(updates.steps.size()),
              fixed(static_cast<double>(draco.sent) / count, 1),
              fixed(static_cast<double>(map.bytes) / count, 0),
              fixed(ratio(map.bytes, raw), 3),
              fixed(ratio(map.bytes, draco.bytes), 3),
              fixed(ratio(map.bytes, plain.bytes), 3)};
  const Cells times = time_cells(updates, bounds, settings);
  cells.insert(cells.end(), times.begin(), times.end());
  print(table_row(cells));
  bounds.max_error = kCoarse * updates.voxel;
  print_coarse(updates, bounds, settings, map.largest_error / updates.voxel);
}

void split_in_parts(const std::string& name, const Mesh& mesh, double voxel, const Settings& settings) {
  print_splits(name, mesh, bounds_of(settings, kMaxError * voxel), settings.part_edges,
               settings.exchange.most_triangles);
}

int run(const Settings& settings) {
  print(
      "Times are of one processor, ms an update.\n" +
      table_head({"sequence", "updates", "blocks an update", "bytes an update", "of raw", "of Draco",
                  "of plain streams", "encode", "decode", "join", "all of the longest", "all over Draco's"}));
  for (const std::string& folder : settings.folders)
    run_updates(value_or_exit(read_updates(folder, folder.substr(folder.find_last_of('/') + 1))), settings);
  if (!settings.wholes.empty())
    for (const int voxels : {16, 8})
      run_updates(value_or_exit(cut_wholes(settings.wholes, "wholes, blocks of " + number(voxels),
                                           settings.voxel, voxels, settings.origin)),
                  settings);
  MapUpdates drive;
  if (settings.steps > 0)
    run_updates(drive = value_or_exit(drive_updates(settings.vertices, settings.steps)), settings);
  print("\n" + table_head({"whole map", "bytes as one stream", "part edge", "parts", "bytes a part",
                           "bytes of primers", "all over one stream"}));
  for (const std::string& file : settings.splits)
    split_in_parts(file, value_or_exit(load_mesh(file)), settings.voxel, settings);
  if (settings.steps > 0) split_in_parts(drive.name, drive.wholes.back(), drive.voxel, settings);
  return 0;
}

}  // namespace
}  // namespace deltamesh::bench

int main(int argc, char** argv) {
  using namespace deltamesh::bench;
  Settings settings;
  CLI::App app("Updates of maps beside raw triangles, Draco and plain streams, block by block.");
  app.add_option("--sequence", settings.folders, "Folders with sequence.json");
  app.add_option("--wholes", settings.wholes,
                 "Folder of whole maps step_00.ply and so on, cut into blocks of 16 and 8 voxels");
  app.add_option("--origin", settings.origin,
                 "Of their blocks, metres: a node of the grid, so that blocks are cut between cubes")
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--split", settings.splits, "Whole maps, to have in parts beside one stream");
  app.add_option("--part-edges", settings.part_edges, "Of their largest parts, metres")
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--voxel", settings.voxel, "Of the whole maps, metres")->capture_default_str();
  app.add_option("--vertices", settings.vertices, "Of the generated drive")->capture_default_str();
  app.add_option("--steps", settings.steps, "Of the generated drive; 0: none")->capture_default_str();
  app.add_option("--most-triangles", settings.exchange.most_triangles, "Of a part of several blocks")
      ->capture_default_str();
  app.add_option("--effort", settings.effort, "Of encoding, 0 to 2")->capture_default_str();
  app.add_option("--color-psnr", settings.color_psnr,
                 "Colours at this mean error, decibels, instead of within 4 of 255; Draco's are within that");
  app.add_option("--rounds", settings.rounds, "Of which times are the medians")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_flag("--compare", settings.exchange.measures, "Measure the receiver's map after every update");
  return parse_and_run(app, argc, argv, [&] { return run(settings); });
}
