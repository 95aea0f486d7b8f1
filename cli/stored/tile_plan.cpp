// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "stored/tile_plan.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "deltamesh/io.h"
#include "stored/quality.h"

namespace deltamesh::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::string path_of(const std::string& folder, const std::string& name) {
  return (fs::path(folder) / "tiles" / name).string();
}

std::vector<std::byte> bytes_of(const std::string& text) {
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  return {first, first + text.size()};
}

Json json_of_key(const PartKey& key) { return {key.level, key.x, key.y, key.z}; }
PartKey key_of(const JsonValue& json) {
  const auto items = json.items(4);
  return {items[0].whole<std::uint8_t>(0, kMostPartLevel), items[1].whole<std::int32_t>(),
          items[2].whole<std::int32_t>(), items[3].whole<std::int32_t>()};
}

/// In model units, as no tile knows the diagonal of the whole map.
Json json_of_quality(const PartQuality& quality) {
  Json json = json_of(quality.attributes);
  json.update(json_of(quality.bounds));
  json["geometry"] = static_cast<int>(quality.geometry);
  json["effort"] = quality.effort;
  return json;
}

PartQuality quality_of(const JsonValue& json) {
  constexpr int kMostEffort = 2;
  PartQuality quality{.bounds = bounds_of(json, false), .attributes = attributes_of(json)};
  if (quality.bounds.empty()) json.refuse("an object with vde, lfe or max_error");
  quality.geometry = static_cast<GeometryCoder>(
      json.member("geometry").whole<int>(0, static_cast<int>(GeometryCoder::kPredictive)));
  quality.effort = json.member("effort").whole<int>(0, kMostEffort);
  return quality;
}

/// Numbers of files.
std::vector<std::uint32_t> numbers_of(const JsonValue& json, std::size_t files) {
  std::vector<std::uint32_t> numbers;
  for (const JsonValue& number : json.items())
    numbers.push_back(number.whole<std::uint32_t>(0, static_cast<std::uint32_t>(files - 1)));
  return numbers;
}

/// A new folder in `folder`, which is made if need be; empty if that fails.
fs::path make_new_folder(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  for (int i = 0; !failed && i < 1000; ++i) {
    const fs::path fresh = folder / ("tiles.new" + std::to_string(i));
    if (fs::create_directory(fresh, failed)) return fresh;
  }
  return {};
}

/// The old plan and its tiles go when the new one is in their place.
Result<void> replace_plan(const fs::path& folder, std::span<const std::byte> map,
                          std::span<const std::byte> plan) {
  const fs::path fresh = make_new_folder(folder);
  if (fresh.empty())
    return Error{.code = ErrorCode::kFileWrite, .message = "cannot make the folder of the plan"};
  const std::string map_file = (fresh / "map").string();
  const std::string plan_file = (fresh / "plan.json").string();
  auto written = write_files(std::array{NewFile{map_file, map}, NewFile{plan_file, plan}});
  const fs::path own = folder / "tiles";
  const fs::path old = fresh.string() + ".old";
  std::error_code failed;
  std::error_code ignored;
  if (written && fs::exists(own, ignored)) fs::rename(own, old, failed);
  if (written && !failed) fs::rename(fresh, own, failed);
  if (failed) {
    fs::rename(old, own, ignored);
    written = Error{.code = ErrorCode::kFileWrite, .message = "cannot replace the folder of the plan"};
  }
  fs::remove_all(written ? old : fresh, ignored);
  return written;
}

void read_plan(const JsonValue& json, FiledPlan& filed) {
  TilePlan& plan = filed.plan;
  for (const JsonValue& file : json.member("files").items()) filed.files.push_back(file.text());
  if (filed.files.empty()) json.member("files").refuse("one name or more");
  plan.quality = quality_of(json.member("quality"));
  if (const auto asked = json.optional_member("asked")) filed.asked = attributes_of(*asked);
  filed.drop_invalid = json.member("drop_invalid").flag();
  for (const JsonValue& hash : json.member("mesh_hashes").items(filed.files.size()))
    plan.mesh_hashes.push_back(hash.whole<std::uint64_t>());
  plan.revision = json.member("revision").whole<std::uint64_t>(1);
  plan.group = json.member("group").whole<std::uint64_t>();
  for (const JsonValue& key : json.member("parts").items()) plan.parts.push_back(key_of(key));
  if (!std::ranges::is_sorted(plan.parts)) json.member("parts").refuse("an array of keys that ascend");
  for (const JsonValue& tile : json.member("tiles").items())
    plan.tiles.push_back({key_of(tile.member("cell")), tile.member("triangles").whole<std::uint64_t>(),
                          numbers_of(tile.member("files"), filed.files.size())});
  if (plan.tiles.empty()) json.member("tiles").refuse("one tile or more");
}

}  // namespace

Result<void> save_plan(const std::string& folder, const FiledPlan& plan) {
  Json json = {{"files", plan.files},
               {"quality", json_of_quality(plan.plan.quality)},
               {"drop_invalid", plan.drop_invalid},
               {"mesh_hashes", plan.plan.mesh_hashes},
               {"revision", plan.plan.revision},
               {"group", plan.plan.group}};
  if (plan.asked) json["asked"] = json_of(*plan.asked);
  json["parts"] = Json::array();
  for (const PartKey& key : plan.plan.parts) json["parts"].push_back(json_of_key(key));
  json["tiles"] = Json::array();
  for (const Tile& tile : plan.plan.tiles)
    json["tiles"].push_back(
        {{"cell", json_of_key(tile.cell)}, {"triangles", tile.triangles}, {"files", tile.meshes}});
  auto message = write_description(plan.plan.description);
  if (!message) return message.error();
  const auto plan_bytes = bytes_of(json.dump(1) + '\n');
  return replace_plan(folder, *message, plan_bytes);
}

bool has_plan(const std::string& folder) {
  std::error_code ignored;
  return fs::exists(path_of(folder, "plan.json"), ignored);
}

std::optional<FiledPlan> load_plan(const std::string& folder, std::string& wrong) {
  const auto message = read_file(path_of(folder, "map"));
  auto description = message ? read_description(*message) : Result<MapDescription>(message.error());
  if (!description) {
    wrong = "tiles/map: " + describe(description.error());
    return std::nullopt;
  }
  FiledPlan plan;
  plan.plan.description = *std::move(description);
  wrong = read_json(path_of(folder, "plan.json"), [&](const JsonValue& json) { read_plan(json, plan); });
  if (wrong.empty()) return plan;
  wrong.insert(0, "tiles/plan.json: ");
  return std::nullopt;
}

std::string tile_file(const std::string& folder, std::size_t tile) {
  return path_of(folder, std::to_string(tile) + ".tile");
}

void delete_unfinished(const std::string& folder) {
  std::error_code ignored;
  std::vector<fs::path> unfinished;
  for (auto file = fs::directory_iterator(fs::path(folder) / "tiles", ignored);
       !ignored && file != fs::directory_iterator(); file.increment(ignored))
    if (file->path().filename().string().find(".tile.") != std::string::npos)
      unfinished.push_back(file->path());
  for (const fs::path& file : unfinished) fs::remove(file, ignored);
}

}  // namespace deltamesh::cli
