// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "commands/tiles.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <system_error>

#include "commands/commands.h"
#include "deltamesh/io.h"
#include "map_files.h"
#include "mesh_files.h"
#include "option_numbers.h"
#include "report/console.h"
#include "report/map.h"
#include "stored/map_bounds.h"
#include "stored/map_lock.h"

namespace deltamesh::cli {
namespace {

namespace fs = std::filesystem;

struct Encoding {
  std::string folder;
  std::size_t tile = 0;
};

/// The plan of a folder; says what to do where there is none.
std::optional<FiledPlan> load_own_plan(const std::string& folder, int& status) {
  if (!has_plan(folder)) {
    print_error(folder, "no tiles are planned here: run `tiles plan` first");
    status = kBadInput;
    return std::nullopt;
  }
  std::string wrong;
  auto plan = load_plan(folder, wrong);
  if (plan) return plan;
  print_error(folder, wrong + "; run `tiles plan` again");
  status = kBadStream;
  return std::nullopt;
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
  int status = kOk;
  const auto plan = load_own_plan(encoding.folder, status);
  if (!plan) return status;
  const auto& tiles = plan->plan.tiles;
  if (encoding.tile >= tiles.size()) {
    print_error(std::to_string(encoding.tile),
                "no such tile; they are numbered from 0 to " + std::to_string(tiles.size() - 1));
    return kUsage;
  }
  const auto parts = load_tile(*plan, encoding.tile, status);
  if (!parts) return status;
  const auto codec = MapCodec::open(plan->plan.description);
  if (!codec) return fail(encoding.folder, codec.error());
  const auto state = encode_tile(*codec, *parts, plan->plan);
  if (!state) return fail("tile " + std::to_string(encoding.tile), state.error());
  if (const auto saved = save_tile(encoding.folder, encoding.tile, *state); !saved)
    return fail(encoding.folder, saved.error());
  std::uint64_t bytes = 0;
  for (const PartEntry& entry : state->manifest.entries) bytes += entry.bytes;
  std::cout << "tile " << encoding.tile << ": " << counted(parts->size(), "part", "parts") << ", "
            << counted(bytes, "byte", "bytes") << '\n';
  return kOk;
}

/// Whether the map that a folder holds, if any, is still the one that tiles were planned to replace, or the
/// one that they make; says so if not.
bool is_next(const std::string& folder, const TilePlan& plan, int& status) {
  if (!is_map(folder)) return true;
  const auto map = load_manifest(folder, status);
  if (!map) return false;
  if (map->revision < plan.revision) return true;
  if (map->revision == plan.revision && map->description == plan.description) return true;
  print_error(folder, "the map has changed since tiles were planned: run `tiles plan` again");
  status = kBadInput;
  return false;
}

/// The parts of every tile, ascending. O(n log n).
std::vector<std::vector<PartKey>> parts_of_tiles(const TilePlan& plan) {
  std::map<PartKey, std::size_t> tiles;
  for (std::size_t i = 0; i < plan.tiles.size(); ++i) tiles.emplace(plan.tiles[i].cell, i);
  std::vector<std::vector<PartKey>> parts(plan.tiles.size());
  for (const PartKey& key : plan.parts)
    for (std::uint8_t level = key.level; level <= kMostPartLevel; ++level)
      if (const auto tile = tiles.find(ancestor(key, level)); tile != tiles.end())
        parts[tile->second].push_back(key);
  return parts;
}

/// Whether a tile's manifest, with the parts that are planned for it, is of the plan.
bool is_planned(const TilePlan& plan, const std::vector<PartKey>& planned, const MapManifest& manifest) {
  return manifest.description == plan.description && manifest.revision == plan.revision &&
         keys_of(manifest) == planned;
}

/// What a tile has encoded, with all parts, those planned, whole; says what is wrong if not.
std::optional<MapManifest> load_encoded(const std::string& folder, const TilePlan& plan, std::size_t number,
                                        const std::vector<PartKey>& planned, int& status) {
  const std::string again = "`deltamesh tiles encode " + folder + ' ' + std::to_string(number) + '`';
  const std::string file = tile_file(folder, number);
  std::error_code ignored;
  if (!fs::exists(file, ignored)) {
    print_error("tile " + std::to_string(number), "not encoded yet; " + again + " does it");
    status = std::max<int>(status, kBadInput);
    return std::nullopt;
  }
  const auto bytes = read_file(file);
  auto manifest = bytes ? read_manifest(*bytes) : Result<MapManifest>(bytes.error());
  if (manifest && is_planned(plan, planned, *manifest))
    return check_parts(folder, *manifest, "; " + again + " writes it again", status)
               ? std::optional(*std::move(manifest))
               : std::nullopt;
  print_error(file, (manifest ? "made by another plan" : describe(manifest.error())) + "; " + again +
                        " writes it again");
  status = std::max<int>(status, kBadStream);
  return std::nullopt;
}

int run_finish(const std::string& folder) {
  int status = kOk;
  const auto plan = load_own_plan(folder, status);
  const auto lock = plan ? MapLock::take(folder, status) : std::nullopt;
  if (!lock || !is_next(folder, plan->plan, status)) return status;
  const auto planned = parts_of_tiles(plan->plan);
  std::vector<MapManifest> tiles;
  for (std::size_t i = 0; i < planned.size(); ++i)
    if (auto tile = load_encoded(folder, plan->plan, i, planned[i], status))
      tiles.push_back(*std::move(tile));
  if (status != kOk) return status;
  const auto manifest = merge_tiles(tiles);
  if (!manifest) return fail(folder, manifest.error());
  const QualityRequest& bounds = plan->plan.quality.bounds;
  MapBounds before;
  if (!load_bounds(folder, *manifest, {.of_positions = true, .of_attributes = true}, before, status))
    return status;
  const auto saved = save_map_with_bounds(
      folder, *manifest, {},
      {.asked = bounds, .bounds = bounds, .attributes = plan->asked, .parts = before.parts});
  if (!saved) return fail(folder, saved.error());
  delete_unfinished(folder);
  print_map(folder, *manifest);
  return kOk;
}

}  // namespace

std::optional<std::vector<TilePart>> load_tile(const FiledPlan& plan, std::size_t number, int& status) {
  const Tile& tile = plan.plan.tiles[number];
  FileOptions options;
  options.drop_invalid = plan.drop_invalid;
  std::vector<Mesh> meshes;
  for (const std::uint32_t mesh : tile.meshes) {
    auto imported = load_mesh(plan.files[mesh], status, options);
    if (!imported) return std::nullopt;
    meshes.push_back(std::move(imported->mesh));
  }
  const std::vector<MeshView> views(meshes.begin(), meshes.end());
  auto parts = split_tile(plan.plan, tile, views);
  if (parts) return *std::move(parts);
  if (const Error& error = parts.error(); error.where_kind == WhereKind::kElement) {
    print_error(plan.files[tile.meshes.at(error.where)],
                "needed for tile " + std::to_string(number) +
                    ", has changed since tiles were planned: run `tiles plan` again");
    status = kBadInput;
  } else {
    status = fail("tile " + std::to_string(number), error);
  }
  return std::nullopt;
}

void add_tiles_command(CLI::App& app, int& status) {
  CLI::App* tiles = app.add_subcommand("tiles", "Maps of many files, encoded tile by tile on many machines");
  tiles->require_subcommand(1);
  add_tiles_plan(*tiles, status);
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
