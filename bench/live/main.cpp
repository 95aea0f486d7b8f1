// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How long the display of a receiver stands still over a link that loses messages, and what the map takes
// there beside a link that loses none. Deterministic but for `--udp`: simulated time, and random numbers of a
// seed.
#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "live/figures.h"
#include "live/first_sight.h"
#include "live/mission.h"
#include "live/over_time.h"
#include "live/run.h"
#include "live/update_cost.h"
#include "report/table.h"
#include "report/text.h"
#include "support/command_line.h"
#include "support/errors.h"

namespace deltamesh::bench {
namespace {

struct Settings {
  std::vector<std::string> folders;
  std::string wholes;
  double voxel = 0.02;  ///< of the wholes, metres
  std::uint64_t vertices = 60'000;
  std::uint32_t steps = 150;
  std::vector<double> losses = {0.02, 0.05, 0.1};
  std::vector<double> round_trips = {0.02, 0.3};
  std::uint32_t seeds = 3;
  double rate = 125'000;
  std::uint32_t mission = 0;  ///< updates; 0: none
  std::vector<std::uint64_t> update_costs;
  std::vector<std::uint64_t> first_sights;
  double slow_rate = 25'000;
  std::vector<std::uint8_t> copy_levels = {0};
  std::size_t message_bytes = 0;
  std::string over_time;  ///< folder for figures over time; empty: none
  bool over_udp = false;
  bool checks = false;
};

/// The bars: longest freeze in seconds, bytes over those without loss.
struct Bar {
  double freeze;
  double bytes;
};
Bar bar_of(double loss) { return loss <= 0.05 ? Bar{1, 1.15} : Bar{2, 1.35}; }

std::string row(const MapUpdates& updates, double round_trip, double loss, const LiveResult& whole,
                const std::vector<LiveResult>& results) {
  const Figures figures = figures_of(results, whole);
  return table_row({updates.name, fixed(1e3 * round_trip, 0), fixed(100 * loss, 0), fixed(figures.longest, 2),
                    fixed(100 * figures.frozen, 0),
                    fixed(figures.bytes / 1e3 / static_cast<double>(updates.steps.size()), 2),
                    fixed(figures.bytes / static_cast<double>(whole.bytes), 3),
                    fixed(figures.bytes_back / 1e3 / whole.seconds, 2), fixed(figures.settled, 2)});
}

/// Whether all bars are met.
bool run_updates(const MapUpdates& updates, const Settings& settings, OverTime& over_time) {
  bool is_met = true;
  for (const double round_trip : settings.round_trips) {
    LiveSettings live;
    live.link = {.delay = round_trip / 2, .bytes_per_second = settings.rate};
    live.view_rate = static_cast<std::uint32_t>(settings.rate);
    live.message_bytes = settings.message_bytes;
    live.has_errors = !settings.over_time.empty();
    const LiveResult whole = run_live(updates, live);
    over_time.add(updates.name, live, whole);
    print(row(updates, round_trip, 0, whole, {whole}));
    for (const double loss : settings.losses) {
      live.link.loss = loss;
      std::vector<LiveResult> results;
      for (live.seed = 1; live.seed <= settings.seeds; ++live.seed) {
        results.push_back(run_live(updates, live));
        over_time.add(updates.name, live, results.back());
      }
      print(row(updates, round_trip, loss, whole, results));
      const Figures figures = figures_of(results, whole);
      const Bar bar = bar_of(loss);
      is_met = is_met && figures.longest <= bar.freeze &&
               figures.bytes <= bar.bytes * static_cast<double>(whole.bytes) && figures.settled >= 0;
    }
  }
  return is_met;
}

/// Whether the bar is met: the update's median is at most kUpdateBar.
bool print_update_costs(const Settings& settings) {
  constexpr double kUpdateBar = 3;  // milliseconds
  bool is_met = true;
  print(table_head({"vertices", "blocks", "parts", "copies up to level", "update of all, ms",
                    "of one block, median, ms", "largest, ms"}));
  for (const std::uint64_t vertices : settings.update_costs) {
    const MapUpdates map = value_or_exit(rooms_at_once(vertices));
    for (const std::uint8_t level : settings.copy_levels) {
      const UpdateCost cost = measure_update_cost(map, level);
      print(table_row({number(cost.vertices), number(cost.blocks), number(cost.parts), number(level),
                       fixed(cost.first, 0), fixed(cost.median, 2), fixed(cost.largest, 2)}));
      is_met = is_met && cost.median <= kUpdateBar;
    }
  }
  return is_met;
}

/// Whether the bars are met: beside the map without copies.
bool print_first_sights(const Settings& settings) {
  constexpr double kSeenBar = 0.5, kThereBar = 1.1, kCopiesBar = 0.1;
  bool is_met = true;
  print(table_head({"vertices", "copies up to level", "all seen after, s", "all there after, s",
                    "kB to the receiver", "kB of copies", "update of all, ms", "longest call, ms"}));
  for (const std::uint64_t vertices : settings.first_sights) {
    const MapUpdates map = value_or_exit(rooms_at_once(vertices));
    const FirstSight without = measure_first_sight(map, 0, settings.slow_rate);
    for (const std::uint8_t level : settings.copy_levels) {
      const FirstSight sight = level == 0 ? without : measure_first_sight(map, level, settings.slow_rate);
      print(table_row({number(map.wholes.front().vertex_count()), number(level), fixed(sight.all_seen, 2),
                       fixed(sight.all_there, 2), fixed(static_cast<double>(sight.bytes) / 1e3, 1),
                       fixed(static_cast<double>(sight.copy_bytes) / 1e3, 1), fixed(sight.update, 0),
                       fixed(sight.longest_call, 1)}));
      is_met = is_met && sight.all_seen >= 0 && sight.all_there >= 0 &&
               (level == 0 ||
                (sight.all_seen <= kSeenBar * without.all_seen &&
                 sight.all_there <= kThereBar * without.all_there &&
                 static_cast<double>(sight.copy_bytes) <= kCopiesBar * static_cast<double>(without.bytes)));
    }
  }
  return is_met;
}

/// Whether the bar is met: memory over the last half, and all receivers have the map. Time is told alone: it
/// depends on what else runs.
bool print_mission(const Settings& settings) {
  constexpr double kMemoryBar = 1.05;
  print(table_head({"tenth of the updates", "MB", "ms an update", "kB an update", "encoded an update"}));
  std::size_t told = 0;
  const MissionResult result =
      run_mission(value_or_exit(drive_updates(settings.vertices, settings.steps)),
                  {.updates = settings.mission}, [&](const MissionTenth& tenth) {
                    print(table_row({number(++told), fixed(tenth.megabytes, 2), fixed(tenth.milliseconds, 2),
                                     fixed(tenth.kilobytes, 2), fixed(tenth.encoded, 2)}));
                  });
  const auto spread = [&](double MissionTenth::*figure) {
    const auto half = std::span(result.tenths).last(result.tenths.size() / 2);
    const auto [least, most] = std::ranges::minmax_element(half, {}, figure);
    return *most.*figure / (*least.*figure);
  };
  const double memory = spread(&MissionTenth::megabytes);
  print(join({"last half, largest over smallest: memory ", fixed(memory, 3), ", time ",
              fixed(spread(&MissionTenth::milliseconds), 3), ", encoded ",
              fixed(spread(&MissionTenth::encoded), 3),
              result.has_all ? "; all receivers have all\n" : "; NOT all receivers have all\n"}));
  return result.has_all && memory <= kMemoryBar;
}

/// Whether the receiver has the whole map in the end, whatever was lost. Times are told alone: they depend on
/// what else runs.
bool print_udp(const Settings& settings) {
  const MapUpdates updates = value_or_exit(drive_updates(settings.vertices, settings.steps));
  LiveSettings live{.view_rate = static_cast<std::uint32_t>(settings.rate)};
  live.link.bytes_per_second = settings.rate;
  live.message_bytes = settings.message_bytes == 0 ? 1200 : settings.message_bytes;
  const LiveResult whole = run_live(updates, live);
  print(table_head({"link", "loss, %", "longest freeze, s", "time in freezes above 1 s, %", "oldest part, s",
                    "kB an update", "kB/s back", "settled after, s"}));
  bool is_met = true;
  const auto tell = [&](const char* link, const LiveResult& result) {
    const Figures figures = figures_of({result}, whole);
    print(table_row({link, fixed(100 * live.link.loss, 0), fixed(figures.longest, 2),
                     fixed(100 * figures.frozen, 0), fixed(figures.oldest, 2),
                     fixed(figures.bytes / 1e3 / static_cast<double>(updates.steps.size()), 2),
                     fixed(figures.bytes_back / 1e3 / whole.seconds, 2), fixed(figures.settled, 2)}));
    is_met = is_met && figures.settled >= 0;
  };
  tell("simulated", whole);
  tell("UDP on loopback", run_live_over_udp(updates, live));
  for (const double loss : settings.losses) {
    live.link.loss = loss;
    tell("simulated", run_live(updates, live));
    tell("UDP on loopback", run_live_over_udp(updates, live));
  }
  return is_met;
}

int run(const Settings& settings) {
  if (settings.over_udp) return print_udp(settings) || !settings.checks ? 0 : 1;
  if (settings.mission > 0) return print_mission(settings) || !settings.checks ? 0 : 1;
  if (!settings.first_sights.empty()) return print_first_sights(settings) || !settings.checks ? 0 : 1;
  if (!settings.update_costs.empty()) return print_update_costs(settings) || !settings.checks ? 0 : 1;
  print(table_head({"sequence", "round trip, ms", "loss, %", "longest freeze, s",
                    "time in freezes above 1 s, %", "kB an update", "over those without loss", "kB/s back",
                    "settled after, s"}));
  bool is_met = true;
  OverTime over_time;
  for (const std::string& folder : settings.folders)
    is_met &= run_updates(value_or_exit(read_updates(folder, folder.substr(folder.find_last_of('/') + 1))),
                          settings, over_time);
  constexpr int kBlockVoxels = 16;
  if (!settings.wholes.empty())
    is_met &= run_updates(value_or_exit(cut_wholes(settings.wholes, "wholes", settings.voxel, kBlockVoxels)),
                          settings, over_time);
  if (settings.steps > 0)
    is_met &=
        run_updates(value_or_exit(drive_updates(settings.vertices, settings.steps)), settings, over_time);
  if (!settings.over_time.empty() && !over_time.write(settings.over_time)) return 1;
  return is_met || !settings.checks ? 0 : 1;
}

}  // namespace
}  // namespace deltamesh::bench

int main(int argc, char** argv) {
  using namespace deltamesh::bench;
  Settings settings;
  CLI::App app("Freezes and bytes of a map over links that lose messages, in simulated time.");
  app.add_option("--sequence", settings.folders, "Folders with sequence.json");
  app.add_option("--wholes", settings.wholes,
                 "Folder of whole maps step_00.ply and so on, cut into blocks of 16 voxels");
  app.add_option("--voxel", settings.voxel, "Of the whole maps, metres")->capture_default_str();
  app.add_option("--vertices", settings.vertices, "Of the generated drive")->capture_default_str();
  app.add_option("--steps", settings.steps, "Of the generated drive; 0: none")->capture_default_str();
  app.add_option("--loss", settings.losses, "Shares of messages")->delimiter(',')->capture_default_str();
  app.add_option("--round-trip", settings.round_trips, "Seconds")->delimiter(',')->capture_default_str();
  app.add_option("--seeds", settings.seeds, "Runs of each")->capture_default_str();
  app.add_option("--rate", settings.rate, "Of the link, bytes per second")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--message-bytes", settings.message_bytes, "Of the largest message, both ways; 0: no limit")
      ->capture_default_str();
  app.add_option("--over-time", settings.over_time,
                 "Folder for what receivers have over time, as CSV and SVG");
  app.add_option("--mission", settings.mission,
                 "Instead: memory and processor time over so many updates, with ten viewers")
      ->check(CLI::Range(10U, 10'000'000U));
  app.add_option("--update-cost", settings.update_costs,
                 "Instead: what an update of one block takes in rooms of so many vertices")
      ->delimiter(',');
  app.add_option("--first-sight", settings.first_sights,
                 "Instead: how soon all of rooms of so many vertices is seen over a slow link")
      ->delimiter(',');
  app.add_option("--slow-rate", settings.slow_rate, "Of that link, bytes per second")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--copy-levels", settings.copy_levels, "Of coarser copies, with these two")
      ->delimiter(',')
      ->capture_default_str();
  app.add_flag(
      "--udp", settings.over_udp,
      "Instead: the drive in real time over UDP on loopback, beside a link without delay; messages of "
      "1,200 bytes by default");
  app.add_flag("--check", settings.checks, "Fail where a bar is missed");
  return parse_and_run(app, argc, argv, [&] { return run(settings); });
}
