// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "commands/tiles.h"
#include "encode_options.h"
#include "map_files.h"
#include "mesh_files.h"
#include "option_numbers.h"
#include "report/console.h"
#include "report/losses.h"
#include "stored/json_value.h"
#include "stored/map_bounds.h"

namespace deltamesh::cli {
namespace {

namespace fs = std::filesystem;

struct Planning {
  std::string folder;
  std::vector<std::string> files;
  MapSettings settings;
  AskedName name;
  std::uint64_t tile_triangles = 2'000'000;
  FileOptions options;
  bool asks_of_attributes = false;
};

/// What parts of all tiles learn from, found in the largest tile.
int add_primers(FiledPlan& plan) {
  const auto largest = std::ranges::max_element(plan.plan.tiles, {}, &Tile::triangles);
  int status = kOk;
  const auto number = static_cast<std::size_t>(largest - plan.plan.tiles.begin());
  auto tile = load_tile(plan, number, status);
  if (!tile) return status;
  std::vector<MapPart> parts;
  for (TilePart& part : *tile) parts.push_back(std::move(part.part));
  auto description = with_primers(plan.plan.description, parts, plan.plan.quality);
  if (!description) return fail("tile " + std::to_string(number), description.error());
  plan.plan.description = *std::move(description);
  return kOk;
}

/// The tiles begin an epoch of the map [MAP-5].
void continue_map(const MapManifest& before, TilePlan& plan) {
  plan.description.epoch = before.description.epoch + 1;
  plan.revision = before.revision + 1;
  plan.group = before.next_group;
}

/// The paths by which tiles find the files, from any folder; says which of them a plan cannot hold.
std::optional<std::vector<std::string>> absolute_paths(const std::vector<std::string>& files) {
  std::vector<std::string> paths;
  for (const std::string& file : files) {
    std::error_code failed;
    paths.push_back(fs::absolute(file, failed).string());
    if (fits_json(paths.back())) continue;
    print_error(paths.back(), "the path is not UTF-8, which plans are written in: rename it");
    return std::nullopt;
  }
  return paths;
}

/// What reading the files did to them.
struct Readings {
  LossReport losses;
  std::uint64_t unreferenced = 0;  ///< vertices that no face uses
  double rounding = 0;
  double uv_scale = 1;
};

/// Has all files looked at. `attributes`: bounds on those of the first, which all have. Returns the exit
/// code.
int add_files(const Planning& planning, const AttributeQuality& attributes, TilePlanner& planner,
              Readings& readings) {
  for (const std::string& file : planning.files) {
    int status = kOk;
    if (!check_is_outside(planning.folder + "/tiles", file, status)) return status;
    const auto imported = load_mesh(file, status, planning.options);
    if (!imported || !check_are_outside(planning.folder + "/tiles", file, imported->report, status))
      return status;
    if (file == planning.files.front() &&
        !check_named_bounds(attributes, file, imported->mesh, status,
                            planning.asks_of_attributes ? "" : planning.folder + "/bounds.json"))
      return status;
    for (const LeftOut& entry : imported->report.left_out)
      readings.losses.leave_out(entry.kind, entry.name, entry.count);
    readings.unreferenced += count_unreferenced(imported->mesh);
    readings.rounding = std::max(readings.rounding, imported->report.position_error);
    readings.uv_scale = std::max(readings.uv_scale, imported->report.uv_scale);
    readings.losses.leave_out(LeftOutKind::kNames, "groups", imported->mesh.group_names.size());
    if (const auto added = planner.add(imported->mesh); !added) return fail_coding(file, added.error());
  }
  return kOk;
}

int run_plan(const Planning& planning) {
  if (planning.tile_triangles < planning.settings.most_triangles) {
    print_error("--tile-triangles", grouped(planning.tile_triangles) + " is less than --part-triangles, " +
                                        grouped(planning.settings.most_triangles));
    return kUsage;
  }
  auto paths = absolute_paths(planning.files);
  if (!paths) return kUsage;
  int status = kOk;
  MapBounds before;
  std::optional<MapManifest> map;
  if (is_map(planning.folder)) {
    map = load_manifest(planning.folder, status);
    const AskedBounds asked{.of_positions = true, .of_attributes = planning.asks_of_attributes};
    if (!map || !load_bounds(planning.folder, *map, asked, before, status)) return status;
  }
  MapSettings settings = planning.settings;
  planning.name.set_in(settings, map ? &map->description : nullptr);
  if (planning.asks_of_attributes) before.attributes = settings.quality.attributes;
  if (before.attributes) settings.quality.attributes = *before.attributes;
  auto planner = TilePlanner::make(settings, planning.tile_triangles);
  if (!planner) return fail("tiles plan", planner.error());
  Readings readings;
  status = add_files(planning, settings.quality.attributes, *planner, readings);
  if (status != kOk) return status;
  auto planned = planner->plan();
  if (!planned) return fail("tiles plan", planned.error());
  FiledPlan plan{.plan = *std::move(planned),
                 .files = *std::move(paths),
                 .drop_invalid = planning.options.drop_invalid,
                 .asked = before.attributes};
  plan.plan.quality.attributes.uv_error /= readings.uv_scale;
  if (plan.plan.tiles.empty()) {
    print_error("tiles plan", "the files have no faces");
    return kBadInput;
  }
  if (map) continue_map(*map, plan.plan);
  if (status = add_primers(plan); status != kOk) return status;
  if (const auto saved = save_plan(planning.folder, plan); !saved)
    return fail(planning.folder, saved.error());
  std::cout << planning.folder << ": " << counted(plan.plan.tiles.size(), "tile", "tiles")
            << ", numbered 0 to " << plan.plan.tiles.size() - 1 << ", "
            << counted(plan.plan.parts.size(), "part", "parts") << '\n';
  if (plan.asked && !planning.asks_of_attributes)
    std::cout << "attribute bounds kept: " << attribute_bounds_text(*plan.asked) << '\n';
  print_dropped(readings.unreferenced, std::cout);
  print_rounding(readings.rounding, std::cout);
  print_stretch(readings.uv_scale, std::cout);
  print_left_out(readings.losses, std::cout);
  return kOk;
}

}  // namespace

void add_tiles_plan(CLI::App& tiles, int& status) {
  const auto planning = std::make_shared<Planning>();
  CLI::App* command = tiles.add_subcommand("plan", "Divide the map of many mesh files into tiles");
  command->add_option("DIR", planning->folder, "folder of the map to be made")->required();
  command->add_option("IN", planning->files, std::string("mesh files: ") + kMeshSuffixes)->required();
  command->add_option("--part-edge", planning->settings.part_edge, "edge of the largest parts, model units")
      ->required();
  command
      ->add_option("--part-triangles", planning->settings.most_triangles,
                   "parts with more are divided, down to an eighth of the edge")
      ->capture_default_str();
  command
      ->add_option("--tile-triangles", planning->tile_triangles,
                   "of a tile at the most, where parts allow; each takes about 300 bytes of memory")
      ->check(refuse_negative)
      ->capture_default_str();
  command->add_option("--map-id", planning->name.id, "which map; where DIR holds one, its number")
      ->check(refuse_negative)
      ->default_str(std::to_string(planning->settings.id));
  command
      ->add_option("--frame", planning->name.frame,
                   "name of the coordinate frame; where DIR holds a map, its frame")
      ->default_str(planning->settings.frame);
  add_part_quality(*command, planning->settings.quality);
  for (const char* bound : {"--max-error", "--vde", "--lfe"}) command->get_option(bound)->type_name("NUMBER");
  command->get_option("--max-error")
      ->description(
          "largest distance of a vertex from its place, model units; \"none\" for no limit beside "
          "--vde or --lfe");
  command->get_option("--vde")->description("largest visual distortion error (rms), model units");
  command->get_option("--lfe")->description("largest low-frequency error (rms), model units");
  command->add_flag("--drop-invalid", planning->options.drop_invalid,
                    "drop faces at vertices that are NaN or infinite");
  command->add_flag("--strict", planning->options.strict, "fail where anything of a mesh file is left out");
  command->footer(
      "Reads every file once, and those of the largest tile again. Files fit together where they have the "
      "same positions; the first says which attributes all have. At least one of --max-error, --vde and "
      "--lfe "
      "is needed, in model units. Where DIR holds a map the tiles replace it, in a new epoch, "
      "with its bounds on attributes where there are no others.\n\n"
      "Example, for 100 tiles:\n"
      "  deltamesh tiles plan city.map blocks/*.ply --part-edge 20 --max-error 0.01\n"
      "  parallel --joblog jobs.log --resume deltamesh tiles encode city.map ::: $(seq 0 99)\n"
      "  deltamesh tiles finish city.map\n");
  command->callback([planning, command, &status] {
    planning->asks_of_attributes = asks_of_attributes(*command);
    status = run_plan(*planning);
  });
}

}  // namespace deltamesh::cli
