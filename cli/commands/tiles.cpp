// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/map/tiles.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "commands/commands.h"
#include "deltamesh/io.h"
#include "encode_options.h"
#include "mesh_files.h"
#include "option_numbers.h"
#include "report/console.h"
#include "report/losses.h"
#include "report/map.h"
#include "tile_plan_file.h"

namespace deltamesh::cli {
namespace {

namespace fs = std::filesystem;

struct Planning {
  std::string folder;
  std::vector<std::string> files;
  MapSettings settings;
  std::uint64_t tile_triangles = 2'000'000;
  FileOptions options;
};

struct Encoding {
  std::string folder;
  std::size_t tile = 0;
};

/// The parts of a tile, from the files that it needs.
std::optional<std::vector<TilePart>> load_tile(const FiledPlan& plan, const Tile& tile, int& status) {
  std::vector<Mesh> meshes;
  for (const std::uint32_t mesh : tile.meshes) {
    auto imported = load_mesh(plan.files[mesh], status);
    if (!imported) return std::nullopt;
    meshes.push_back(std::move(imported->mesh));
  }
  const std::vector<MeshView> views(meshes.begin(), meshes.end());
  auto parts = split_tile(plan.plan, tile, views);
  if (parts) return *std::move(parts);
  status = fail("tile of " + key_text(tile.cell), parts.error());
  return std::nullopt;
}

/// What parts of all tiles learn from, found in the largest tile.
int add_primers(FiledPlan& plan) {
  const auto largest = std::ranges::max_element(plan.plan.tiles, {}, &Tile::triangles);
  int status = kOk;
  auto tile = load_tile(plan, *largest, status);
  if (!tile) return status;
  std::vector<MapPart> parts;
  for (TilePart& part : *tile) parts.push_back(std::move(part.part));
  auto description = with_primers(plan.plan.description, parts, plan.plan.quality);
  if (!description) return fail("tile of " + key_text(largest->cell), description.error());
  plan.plan.description = *std::move(description);
  return kOk;
}

int run_plan(const Planning& planning) {
  auto planner = TilePlanner::make(planning.settings, planning.tile_triangles);
  if (!planner) return fail("tiles plan", planner.error());
  FiledPlan plan;
  LossReport losses;
  double rounding = 0;
  double uv_scale = 1;
  for (const std::string& file : planning.files) {
    int status = kOk;
    const auto imported = load_mesh(file, status, planning.options);
    if (!imported) return status;
    for (const LeftOut& entry : imported->report.left_out)
      losses.leave_out(entry.kind, entry.name, entry.count);
    rounding = std::max(rounding, imported->report.position_error);
    uv_scale = std::max(uv_scale, imported->report.uv_scale);
    losses.leave_out(LeftOutKind::kNames, "groups", imported->mesh.group_names.size());
    if (const auto added = planner->add(imported->mesh); !added) return fail(file, added.error());
    std::error_code failed;
    plan.files.push_back(fs::absolute(file, failed).string());
  }
  auto planned = planner->plan();
  if (!planned) return fail("tiles plan", planned.error());
  plan.plan = *std::move(planned);
  plan.plan.quality.attributes.uv_error /= uv_scale;
  if (plan.plan.tiles.empty()) {
    print_error("tiles plan", "the files have no faces");
    return kBadInput;
  }
  if (const int status = add_primers(plan); status != kOk) return status;
  if (const auto saved = save_plan(planning.folder, plan); !saved)
    return fail(planning.folder, saved.error());
  std::cout << planning.folder << ": " << counted(plan.plan.tiles.size(), "tile", "tiles")
            << ", numbered from 0, " << counted(plan.plan.parts.size(), "part", "parts") << '\n';
  print_rounding(rounding, std::cout);
  print_stretch(uv_scale, std::cout);
  print_left_out(losses, std::cout);
  return kOk;
}

/// Parts first, then the file that says that they are there.
Result<void> save_tile(const std::string& folder, std::size_t number, const MapState& state) {
  std::error_code failed;
  fs::create_directories(fs::path(folder) / "parts", failed);
  if (failed) return Error{.code = ErrorCode::kFileWrite, .message = "cannot make the folder of parts"};
  for (std::size_t i = 0; i < state.octets.size(); ++i) {
    const PartEntry& entry = state.manifest.entries[i];
    const fs::path file = fs::path(folder) / part_file(entry.key, entry.revision, entry.hash);
    if (auto done = write_file(file.string(), state.octets[i]); !done) return done;
  }
  const auto manifest = write_manifest(state.manifest);
  if (!manifest) return manifest.error();
  return write_file(tile_file(folder, number), *manifest);
}

int run_encode(const Encoding& encoding) {
  const auto plan = load_plan(encoding.folder);
  if (!plan) return fail(encoding.folder, plan.error());
  const auto& tiles = plan->plan.tiles;
  if (encoding.tile >= tiles.size()) {
    print_error(std::to_string(encoding.tile),
                "no such tile; they are numbered from 0 to " + std::to_string(tiles.size() - 1));
    return kUsage;
  }
  int status = kOk;
  const auto parts = load_tile(*plan, tiles[encoding.tile], status);
  if (!parts) return status;
  const auto codec = MapCodec::open(plan->plan.description);
  if (!codec) return fail(encoding.folder, codec.error());
  const auto state = encode_tile(*codec, *parts, plan->plan.quality);
  if (!state) return fail("tile " + std::to_string(encoding.tile), state.error());
  if (const auto saved = save_tile(encoding.folder, encoding.tile, *state); !saved)
    return fail(encoding.folder, saved.error());
  std::uint64_t bytes = 0;
  for (const PartEntry& entry : state->manifest.entries) bytes += entry.bytes;
  std::cout << "tile " << encoding.tile << ": " << counted(parts->size(), "part", "parts") << ", "
            << counted(bytes, "byte", "bytes") << '\n';
  return kOk;
}

int run_finish(const std::string& folder) {
  const auto plan = load_plan(folder);
  if (!plan) return fail(folder, plan.error());
  std::vector<MapManifest> tiles;
  std::string missing;
  for (std::size_t i = 0; i < plan->plan.tiles.size(); ++i) {
    const std::string file = tile_file(folder, i);
    std::error_code ignored;
    if (!fs::exists(file, ignored)) {
      missing += ' ' + std::to_string(i);
      continue;
    }
    const auto bytes = read_file(file);
    if (!bytes) return fail(file, bytes.error());
    auto tile = read_manifest(*bytes);
    if (!tile) return fail(file, tile.error());
    tiles.push_back(*std::move(tile));
  }
  if (!missing.empty()) {
    print_error(folder, "these tiles are not encoded yet:" + missing);
    return kBadInput;
  }
  const auto manifest = merge_tiles(tiles);
  if (!manifest) return fail(folder, manifest.error());
  if (const auto saved = save_map(folder, *manifest, {}); !saved) return fail(folder, saved.error());
  delete_unfinished(folder);
  print_map(folder, *manifest);
  return kOk;
}

void add_plan(CLI::App& tiles, int& status) {
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
  command->add_option("--map-id", planning->settings.id, "which map")
      ->check(refuse_negative)
      ->capture_default_str();
  command->add_option("--frame", planning->settings.frame, "name of the coordinate frame")
      ->capture_default_str();
  add_part_quality(*command, planning->settings.quality);
  command->add_flag("--strict", planning->options.strict, "fail where anything of a mesh file is left out");
  command->footer(
      "Reads every file once, and those of the largest tile again. Files fit together where they have the "
      "same "
      "positions. Bounds are in model units.\n\n"
      "Example:\n  deltamesh tiles plan city.map blocks/*.ply --part-edge 20 --max-error 0.01\n"
      "  parallel --joblog jobs.log --resume deltamesh tiles encode city.map ::: $(seq 0 99)\n"
      "  deltamesh tiles finish city.map\n");
  command->callback([planning, &status] { status = run_plan(*planning); });
}

}  // namespace

void add_tiles_command(CLI::App& app, int& status) {
  CLI::App* tiles = app.add_subcommand("tiles", "Maps of many files, encoded tile by tile on many machines");
  tiles->require_subcommand(1);
  add_plan(*tiles, status);
  const auto encoding = std::make_shared<Encoding>();
  CLI::App* encode =
      tiles->add_subcommand("encode", "Encode one tile; may be killed and run again, in any order");
  encode->add_option("DIR", encoding->folder, "folder of the map")->required();
  encode->add_option("N", encoding->tile, "number of the tile, from 0 on")
      ->required()
      ->check(refuse_negative);
  encode->callback([encoding, &status] { status = run_encode(*encoding); });
  const auto folder = std::make_shared<std::string>();
  CLI::App* finish = tiles->add_subcommand("finish", "Make the map of all tiles, once they are encoded");
  finish->add_option("DIR", *folder, "folder of the map")->required();
  finish->callback([folder, &status] { status = run_finish(*folder); });
}

}  // namespace deltamesh::cli
