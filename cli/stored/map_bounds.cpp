// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "map_bounds_file.h"

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <system_error>

#include "deltamesh/io.h"
#include "option_numbers.h"
#include "report/console.h"

namespace deltamesh::cli {
namespace {

using Json = nlohmann::json;

struct Member {
  const char* key;
  const char* name;
  std::optional<QualityBound> QualityRequest::*bound;
};
constexpr std::array<Member, 3> kMembers{{{"max_error", "max error", &QualityRequest::max_error},
                                          {"vde", "vde", &QualityRequest::vde},
                                          {"lfe", "lfe", &QualityRequest::lfe}}};

std::string path_in(const std::string& folder) {
  return (std::filesystem::path(folder) / "bounds.json").string();
}

/// As the command line has bounds, so that none and percents stay what they are.
Json json_of(const QualityRequest& request) {
  Json json = Json::object();
  for (const Member& member : kMembers)
    if (const auto& bound = request.*member.bound) json[member.key] = text_of(*bound);
  return json;
}

/// Empty: not what json_of() makes.
std::optional<QualityRequest> request_of(const Json& json) {
  if (!json.is_object()) return std::nullopt;
  QualityRequest request;
  for (const Member& member : kMembers) {
    if (!json.contains(member.key)) continue;
    if (!json[member.key].is_string()) return std::nullopt;
    request.*member.bound = parse_bound(json[member.key].get<std::string>());
    if (!(request.*member.bound) || !((request.*member.bound)->value > 0)) return std::nullopt;
  }
  return request;
}

}  // namespace

Result<void> load_bounds(const std::string& folder, MapState& state) {
  std::error_code ignored;
  if (!std::filesystem::exists(path_in(folder), ignored)) return {};
  const auto bytes = read_file(path_in(folder));
  if (!bytes) return bytes.error();
  const auto* const text = reinterpret_cast<const char*>(bytes->data());
  const Json json = Json::parse(text, text + bytes->size(), nullptr, false);
  const auto asked = json.is_object() ? request_of(json.value("asked", Json())) : std::nullopt;
  const auto bounds = json.is_object() ? request_of(json.value("bounds", Json())) : std::nullopt;
  if (!asked || !bounds)
    return Error{.code = ErrorCode::kInvalidFile,
                 .message = "bounds.json does not hold a map's bounds; delete that file and ask for bounds"};
  state.asked = *asked;
  state.bounds = *bounds;
  return {};
}

Result<void> save_bounds(const std::string& folder, const MapState& state) {
  if (state.asked.empty() && state.bounds.empty()) {
    std::error_code ignored;
    std::filesystem::remove(path_in(folder), ignored);  // of a map that was deleted
    return {};
  }
  const Json json{{"asked", json_of(state.asked)}, {"bounds", json_of(state.bounds)}};
  const std::string text = json.dump() + '\n';
  return write_file(path_in(folder), std::as_bytes(std::span(text)));
}

std::string bounds_text(const MapState& state) {
  const bool is_default = state.asked.empty();
  std::string text;
  for (const Member& member : kMembers) {
    const auto& asked = (is_default ? state.bounds : state.asked).*member.bound;
    if (!asked) continue;
    text += (text.empty() ? "" : ", ") + std::string(member.name) + ' ';
    const auto& bound = state.bounds.*member.bound;
    text += is_default ? brief(asked->value) : text_of(*asked);
    if (asked->unit == QualityUnit::kDiagonal && bound) text += " = " + brief(bound->value);
  }
  return text.empty() ? "none yet" : text;
}

}  // namespace deltamesh::cli
