// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Updates of maps: bytes and times beside raw triangles, Draco block by block and our own streams block by
// block; and what need not be sent as it is good enough. Whole maps in parts: bytes beside one stream.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "deltamesh/compare.h"
#include "deltamesh/io.h"
#include "deltamesh/map/join.h"
#include "deltamesh/map/map_codec.h"
#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"
#include "map/map_peers.h"
#include "map/map_splits.h"
#include "map/map_updates.h"
#include "support/or_exit.h"
#include "support/processor_seconds.h"

namespace deltamesh::bench {
namespace {

constexpr int kColorError = 4;      // of 255
constexpr double kMaxError = 0.05;  // voxels
constexpr double kCoarse = 0.25;    // voxels, where older versions may stay

struct Settings {
  std::uint32_t most_triangles = 24576;  // parts of up to 12 KB at these errors
  int effort = 0;
  int rounds = 3;
  bool compares = false;
  std::vector<double> part_edges = {8, 4, 2, 1};
};

/// Adds the seconds of `work` to `sum`.
template <class Work>
void add_seconds(double& sum, Work&& work) {
  const double start = processor_seconds();
  work();
  sum += processor_seconds() - start;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// What a sequence took.
struct Sums {
  std::uint64_t bytes = 0;
  std::uint64_t sent = 0;
  std::uint64_t kept = 0;
  double encode = 0;  ///< seconds of processor time, as all times here
  double decode = 0;
  double join = 0;            ///< of the parts that an update changed, to one mesh
  double largest_update = 0;  ///< encode, decode and join
  double largest_error = 0;   ///< of the receiver's map against the source, model units; where measured
};

MapDescription description_of(const MapUpdates& updates, double max_error) {
  MapDescription description{.id = 1, .epoch = 1, .frame = "map"};
  description.lattice = {.origin = updates.origin, .step_exponent = step_exponent_for(max_error)};
  description.cell_steps =
      static_cast<std::uint32_t>(std::lround(updates.block_metres / description.lattice.step()));
  for (const Attribute& a : updates.steps.front().changed.front().mesh.attributes)
    description.attributes.push_back({a.kind, a.type, a.components, a.normalized, a.name});
  return description;
}

/// With primers from the parts of the first update.
MapDescription primed(const MapDescription& description, const MapUpdates& updates, double max_error,
                      const SenderOptions& options) {
  Splitter splitter = value_or_exit(Splitter::make(description, options.split));
  std::vector<MapBlock> blocks;
  for (const SequenceBlock& block : updates.steps.front().changed) blocks.push_back({block.id, block.mesh});
  const MapChange change = value_or_exit(splitter.update(blocks));
  std::vector<MapPart> parts;
  for (const ChangedPart& changed : change.changed) parts.push_back(changed.part);
  PartQuality quality;
  quality.bounds.max_error = QualityBound{max_error};
  quality.attributes.color_error = kColorError;
  quality.effort = options.effort;
  return value_or_exit(with_primers(description, parts, quality));
}

Mesh join_parts(const MapReceiver& receiver, const std::vector<PartKey>& keys) {
  std::vector<MapPart> parts;
  for (const PartKey& key : keys) parts.push_back(*receiver.find(key));
  return value_or_exit(join(parts));
}

void join_changed(MapReceiver& receiver) { join_parts(receiver, receiver.take_change().changed); }

double error_of(const MapReceiver& receiver, const Mesh& source) {
  const Mesh joined = join_parts(receiver, receiver.shown());
  const Comparison comparison = value_or_exit(compare(source, joined));
  return comparison.corresponding ? comparison.quality.max_error : comparison.surface_max;
}

/// A sender and a receiver next to each other.
Sums run_map(const MapUpdates& updates, double max_error, bool keeps_good_enough, bool measures,
             const Settings& settings) {
  SenderOptions options;
  options.split.most_triangles = settings.most_triangles;
  options.effort = settings.effort;
  options.keeps_good_enough = keeps_good_enough;
  const MapDescription description = primed(description_of(updates, max_error), updates, max_error, options);
  MapSender sender = value_or_exit(MapSender::make(description, options));
  MapReceiver receiver(1, description.id);
  View view;
  view.max_error = static_cast<float>(max_error);
  view.color_error = kColorError;
  receiver.set_view(view);
  Sums sums;
  double now = 0;
  const auto exchange = [&] {
    check_or_exit(sender.hear(value_or_exit(receiver.view_message()), now += 2));
    std::vector<std::vector<std::byte>> messages;
    add_seconds(sums.encode, [&] { messages = value_or_exit(sender.messages_for(1, now)); });
    for (const auto& message : messages) sums.bytes += message.size();
    add_seconds(sums.decode, [&] {
      for (const auto& message : messages) check_or_exit(receiver.apply(message));
    });
  };
  exchange();  // the map's message
  for (std::size_t i = 0; i < updates.steps.size(); ++i) {
    const Mesh nothing;
    std::vector<MapBlock> blocks;
    for (const SequenceBlock& block : updates.steps[i].changed) blocks.push_back({block.id, block.mesh});
    for (const SequenceBlockId& id : updates.steps[i].removed) blocks.push_back({id, nothing});
    const double before = sums.encode + sums.decode + sums.join;
    add_seconds(sums.encode, [&] { check_or_exit(sender.update(blocks)); });
    exchange();
    add_seconds(sums.join, [&] { join_changed(receiver); });
    sums.largest_update = std::max(sums.largest_update, sums.encode + sums.decode + sums.join - before);
    if (measures) sums.largest_error = std::max(sums.largest_error, error_of(receiver, updates.wholes[i]));
  }
  sums.sent = sender.counts().parts_sent;
  sums.kept = sender.counts().kept;
  return sums;
}

template <class Code>
Sums run_blocks(const MapUpdates& updates, Code code) {
  Sums sums;
  for (const SequenceStep& step : updates.steps) {
    for (const SequenceBlock& block : step.changed) {
      const CodedBlock coded = code(block.mesh);
      sums.bytes += coded.bytes;
      sums.encode += coded.encode_seconds;
      sums.decode += coded.decode_seconds;
      ++sums.sent;
    }
  }
  return sums;
}

template <class T>
double ratio(T a, T b) {
  return b == 0 ? 0 : static_cast<double>(a) / static_cast<double>(b);
}

Sums draco_of(const MapUpdates& updates) {
  const double fine = kMaxError * updates.voxel;
  return run_blocks(updates, [&](const Mesh& block) { return draco_block(block, fine, kColorError); });
}

/// Medians of rounds in which Draco and the map take turns.
void print_times(const MapUpdates& updates, double max_error, const Settings& settings) {
  const auto count = static_cast<double>(updates.steps.size());
  std::vector<double> encode, decode, join, largest, ratios;
  for (int i = 0; i < settings.rounds; ++i) {
    const Sums draco = draco_of(updates);
    const Sums map = run_map(updates, max_error, true, false, settings);
    encode.push_back(1e3 * map.encode / count);
    decode.push_back(1e3 * map.decode / count);
    join.push_back(1e3 * map.join / count);
    largest.push_back(1e3 * map.largest_update);
    ratios.push_back((map.encode + map.decode + map.join) / (draco.encode + draco.decode));
  }
  std::printf(" %.1f | %.1f | %.1f | %.1f | %.2f |\n", median(encode), median(decode), median(join),
              median(largest), median(ratios));
}

void run(const MapUpdates& updates, const Settings& settings) {
  const auto count = static_cast<double>(updates.steps.size());
  const double fine = kMaxError * updates.voxel;
  std::uint64_t raw = 0;
  for (const SequenceStep& step : updates.steps)
    for (const SequenceBlock& block : step.changed) raw += raw_bytes(block.mesh);
  const Sums map = run_map(updates, fine, true, settings.compares, settings);
  const Sums draco = draco_of(updates);
  const Sums plain = run_blocks(
      updates, [&](const Mesh& block) { return plain_block(block, fine, kColorError, settings.effort); });
  std::printf("| %s | %zu | %.1f | %.0f | %.3f | %.3f | %.3f |", updates.name.c_str(), updates.steps.size(),
              static_cast<double>(draco.sent) / count, static_cast<double>(map.bytes) / count,
              ratio(map.bytes, raw), ratio(map.bytes, draco.bytes), ratio(map.bytes, plain.bytes));
  print_times(updates, fine, settings);
  std::fflush(stdout);

  const double coarse = kCoarse * updates.voxel;
  const Sums all = run_map(updates, coarse, false, false, settings);
  const Sums some = run_map(updates, coarse, true, settings.compares, settings);
  std::printf("  at %.2f voxel: bytes of sending every changed part %.3f, parts kept as good enough %.3f",
              kCoarse, ratio(some.bytes, all.bytes), ratio(some.kept, some.kept + some.sent));
  if (settings.compares)
    std::printf("; largest errors at the receiver, voxels: %.4f of %.2f, %.4f of %.2f",
                map.largest_error / updates.voxel, kMaxError, some.largest_error / updates.voxel, kCoarse);
  std::printf("\n");
  std::fflush(stdout);
}

void print_splits_header() {
  std::printf(
      "\n| whole map | bytes as one stream | part edge | parts | bytes a part | bytes of primers | all over "
      "one stream |\n"
      "|---|---|---|---|---|---|---|\n");
}

void split_in_parts(const std::string& name, const Mesh& mesh, double voxel, const Settings& settings) {
  print_splits(name, mesh, kMaxError * voxel, kColorError, settings.effort, settings.part_edges,
               settings.most_triangles);
}

}  // namespace
}  // namespace deltamesh::bench

int main(int argc, char** argv) {
  using namespace deltamesh;
  using namespace deltamesh::bench;
  Settings settings;
  std::vector<std::string> folders;
  std::string wholes;
  std::vector<std::string> splits;
  double voxel = 0.04;
  std::uint64_t vertices = 50'000;
  std::uint32_t steps = 20;
  CLI::App app("Updates of maps beside raw triangles, Draco and plain streams, block by block.");
  app.add_option("--sequence", folders, "Folders with sequence.json");
  app.add_option("--wholes", wholes,
                 "Folder of whole maps step_00.ply and so on, cut into blocks of 16 and 8 voxels");
  app.add_option("--split", splits, "Whole maps, to have in parts beside one stream");
  app.add_option("--part-edges", settings.part_edges, "Of their largest parts, metres")
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--voxel", voxel, "Of the whole maps, metres")->capture_default_str();
  app.add_option("--vertices", vertices, "Of the generated drive")->capture_default_str();
  app.add_option("--steps", steps, "Of the generated drive; 0: none")->capture_default_str();
  app.add_option("--most-triangles", settings.most_triangles, "Of a part of several blocks")
      ->capture_default_str();
  app.add_option("--effort", settings.effort, "Of encoding, 0 to 9")->capture_default_str();
  app.add_option("--rounds", settings.rounds, "Of which times are the medians")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_flag("--compare", settings.compares, "Measure the receiver's map after every update");
  CLI11_PARSE(app, argc, argv);
  std::printf(
      "Times are of one processor, ms an update.\n"
      "| sequence | updates | blocks an update | bytes an update | of raw | of Draco | of plain streams | "
      "encode | decode | join | all of the longest | all over Draco's |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const std::string& folder : folders)
    run(value_or_exit(read_updates(folder, folder.substr(folder.find_last_of('/') + 1))), settings);
  if (!wholes.empty())
    for (const int voxels : {16, 8})
      run(value_or_exit(cut_wholes(wholes, "wholes, blocks of " + std::to_string(voxels), voxel, voxels)),
          settings);
  MapUpdates drive;
  if (steps > 0) run(drive = value_or_exit(drive_updates(vertices, steps)), settings);
  print_splits_header();
  for (const std::string& file : splits)
    split_in_parts(file, value_or_exit(read_mesh_file(file)).mesh, voxel, settings);
  if (steps > 0) split_in_parts(drive.name, drive.wholes.back(), drive.voxel, settings);
}
