// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "tile_plan_file.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "deltamesh/io.h"
#include "option_numbers.h"

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

Json json_of(const PartKey& key) { return {key.level, key.x, key.y, key.z}; }
PartKey key_of(const Json& json) { return {json.at(0), json.at(1), json.at(2), json.at(3)}; }

Json json_of(const PartQuality& quality) {
  Json json;
  const auto put = [&](const char* name, const std::optional<QualityBound>& bound) {
    if (bound) json[name] = text_of(*bound);
  };
  put("vde", quality.bounds.vde);
  put("lfe", quality.bounds.lfe);
  put("max_error", quality.bounds.max_error);
  const AttributeQuality& attributes = quality.attributes;
  json["normal_error"] = attributes.normal_error;
  if (attributes.tangent_error) json["tangent_error"] = *attributes.tangent_error;
  json["uv_error"] = attributes.uv_error;
  if (attributes.color_error) json["color_error"] = *attributes.color_error;
  if (attributes.color_rms) json["color_rms"] = *attributes.color_rms;
  json["weight_error"] = attributes.weight_error;
  json["named"] = Json::array();
  for (const NamedBound& bound : attributes.named)
    json["named"].push_back({bound.name, bound.error, bound.is_mean});
  json["geometry"] = static_cast<int>(quality.geometry);
  json["effort"] = quality.effort;
  return json;
}

PartQuality quality_of(const Json& json) {
  PartQuality quality;
  const auto get = [&](const char* name, std::optional<QualityBound>& bound) {
    if (json.contains(name)) bound = parse_bound(json.at(name).get<std::string>()).value();
  };
  get("vde", quality.bounds.vde);
  get("lfe", quality.bounds.lfe);
  get("max_error", quality.bounds.max_error);
  AttributeQuality& attributes = quality.attributes;
  attributes.normal_error = json.at("normal_error");
  if (json.contains("tangent_error")) attributes.tangent_error = json.at("tangent_error").get<double>();
  attributes.uv_error = json.at("uv_error");
  if (json.contains("color_error")) attributes.color_error = json.at("color_error").get<double>();
  if (json.contains("color_rms")) attributes.color_rms = json.at("color_rms").get<double>();
  attributes.weight_error = json.at("weight_error");
  for (const Json& bound : json.at("named"))
    attributes.named.push_back({bound.at(0), bound.at(1), bound.at(2)});
  quality.geometry = static_cast<GeometryCoder>(json.at("geometry").get<int>());
  quality.effort = json.at("effort");
  return quality;
}

}  // namespace

Result<void> save_plan(const std::string& folder, const FiledPlan& plan) {
  Json json = {{"files", plan.files},
               {"quality", json_of(plan.plan.quality)},
               {"drop_invalid", plan.drop_invalid},
               {"mesh_hashes", plan.plan.mesh_hashes},
               {"revision", plan.plan.revision},
               {"group", plan.plan.group}};
  json["parts"] = Json::array();
  for (const PartKey& key : plan.plan.parts) json["parts"].push_back(json_of(key));
  json["tiles"] = Json::array();
  for (const Tile& tile : plan.plan.tiles)
    json["tiles"].push_back(
        {{"cell", json_of(tile.cell)}, {"triangles", tile.triangles}, {"files", tile.meshes}});
  auto message = write_description(plan.plan.description);
  if (!message) return message.error();
  std::error_code failed;
  const fs::path own = fs::path(folder) / "tiles";
  fs::remove_all(own, failed);
  if (!failed) fs::create_directories(own, failed);
  if (failed) return Error{.code = ErrorCode::kFileWrite, .message = "cannot make the folder of the plan"};
  if (auto done = write_file(path_of(folder, "map"), *message); !done) return done;
  return write_file(path_of(folder, "plan.json"), bytes_of(json.dump(1) + '\n'));
}

bool has_plan(const std::string& folder) {
  std::error_code ignored;
  return fs::exists(path_of(folder, "plan.json"), ignored);
}

Result<FiledPlan> load_plan(const std::string& folder) {
  const auto text = read_file(path_of(folder, "plan.json"));
  if (!text) return text.error();
  const auto message = read_file(path_of(folder, "map"));
  if (!message) return message.error();
  auto description = read_description(*message);
  if (!description) return description.error();
  FiledPlan plan;
  plan.plan.description = *std::move(description);
  try {
    const auto* first = reinterpret_cast<const char*>(text->data());
    const Json json = Json::parse(first, first + text->size());
    plan.files = json.at("files").get<std::vector<std::string>>();
    plan.plan.quality = quality_of(json.at("quality"));
    plan.drop_invalid = json.at("drop_invalid");
    plan.plan.mesh_hashes = json.at("mesh_hashes").get<std::vector<std::uint64_t>>();
    plan.plan.revision = json.at("revision");
    plan.plan.group = json.at("group");
    for (const Json& key : json.at("parts")) plan.plan.parts.push_back(key_of(key));
    for (const Json& tile : json.at("tiles"))
      plan.plan.tiles.push_back({key_of(tile.at("cell")), tile.at("triangles"),
                                 tile.at("files").get<std::vector<std::uint32_t>>()});
    for (const Tile& tile : plan.plan.tiles)
      for (const std::uint32_t mesh : tile.meshes)
        (void)plan.files.at(mesh), (void)plan.plan.mesh_hashes.at(mesh);
    if (plan.plan.tiles.empty())
      return Error{.code = ErrorCode::kCorrupt, .message = "tiles/plan.json has no tiles"};
  } catch (const std::exception&) {
    return Error{.code = ErrorCode::kCorrupt, .message = "tiles/plan.json is not a plan of tiles"};
  }
  return plan;
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
