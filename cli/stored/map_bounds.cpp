// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "stored/map_bounds.h"

#include <array>
#include <filesystem>
#include <system_error>

#include "deltamesh/files.h"
#include "exit_codes.h"
#include "option_numbers.h"
#include "report/console.h"
#include "stored/quality.h"

namespace deltamesh::cli {
namespace {

std::string path_in(const std::string& folder) {
  return (std::filesystem::path(folder) / "bounds.json").string();
}

/// Returns what is wrong with the file; empty: nothing.
std::string read_bounds(const std::string& path, MapBounds& bounds) {
  return read_json(path, [&](const JsonValue& json) {
    bounds.asked = bounds_of(json.member("asked"), true);
    bounds.bounds = bounds_of(json.member("bounds"), false);
    if (const auto attributes = json.optional_member("attributes"))
      bounds.attributes = attributes_of(*attributes);
    if (const auto parts = json.optional_member("parts"))
      bounds.parts = MapParts{.most_triangles = parts->member("most_triangles").whole<std::uint32_t>(1),
                              .levels = parts->member("levels").whole<std::uint8_t>(0, kMostLevels)};
  });
}

}  // namespace

bool load_bounds(const std::string& folder, const MapManifest& manifest, const AskedBounds& asked,
                 MapBounds& bounds, int& status) {
  std::error_code ignored;
  const bool is_there = std::filesystem::exists(path_in(folder), ignored);
  const std::string wrong = is_there ? read_bounds(path_in(folder), bounds) : "";
  if (!wrong.empty()) {
    print_error(path_in(folder), wrong + "; delete that file and ask for bounds");
    status = kBadStream;
    return false;
  }
  const bool says_all =
      asked.of_positions && (asked.of_attributes || manifest.description.attributes.empty());
  if (!bounds.bounds.empty() || says_all || manifest.entries.empty()) return true;
  print_error(folder,
              "no file bounds.json tells which bounds this map keeps: ask for those of positions, and for "
              "those of attributes where it has any");
  status = kBadInput;
  return false;
}

Result<void> save_map_with_bounds(const std::string& folder, const MapManifest& manifest,
                                  std::span<const NewPart> parts, const MapBounds& bounds) {
  nlohmann::json json{{"asked", json_of(bounds.asked)}, {"bounds", json_of(bounds.bounds)}};
  if (bounds.parts)
    json["parts"] = {{"most_triangles", bounds.parts->most_triangles}, {"levels", bounds.parts->levels}};
  if (bounds.attributes) json["attributes"] = json_of(*bounds.attributes);
  const std::string text = json.dump() + '\n';
  return save_map(folder, manifest, parts,
                  std::array{NewFile{path_in(folder), std::as_bytes(std::span(text))}});
}

std::string bounds_text(const MapBounds& map) {
  const bool is_default = map.asked.empty();
  std::string text;
  for (const PositionBound& member : kPositionBounds) {
    const auto& asked = (is_default ? map.bounds : map.asked).*member.bound;
    if (!asked) continue;
    text += (text.empty() ? "" : ", ") + std::string(member.name) + ' ';
    const auto& bound = map.bounds.*member.bound;
    text += is_default ? brief(asked->value) : text_of(*asked);
    if (asked->unit == QualityUnit::kDiagonal && bound) text += " = " + brief(bound->value);
  }
  return text.empty() ? "none yet" : text;
}

std::string attribute_bounds_text(const AttributeQuality& quality) {
  const AttributeQuality usual;
  std::string text;
  const auto add = [&](const std::string& name, double bound, bool is_mean = false) {
    text += (text.empty() ? "" : ", ") + name + ' ' + brief(bound) + (is_mean ? " (rms)" : "");
  };
  if (quality.normal_error != usual.normal_error) add("normals", quality.normal_error);
  if (quality.tangent_error) add("tangents", *quality.tangent_error);
  if (quality.uv_error != usual.uv_error) add("texture coordinates", quality.uv_error);
  if (quality.color_error) add("colours", *quality.color_error);
  if (quality.color_rms) add("colours", *quality.color_rms, true);
  if (quality.weight_error != usual.weight_error) add("weights", quality.weight_error);
  for (const NamedBound& bound : quality.named) add(bound.name, bound.error, bound.is_mean);
  return text.empty() ? "as by default" : text;
}

}  // namespace deltamesh::cli
