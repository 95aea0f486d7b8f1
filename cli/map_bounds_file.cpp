// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "map_bounds_file.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <utility>

#include "deltamesh/io.h"

namespace deltamesh::cli {
namespace {

using Member = std::optional<QualityBound> QualityRequest::*;
constexpr std::array<std::pair<const char*, Member>, 3> kMembers{{{"vde", &QualityRequest::vde},
                                                                  {"lfe", &QualityRequest::lfe},
                                                                  {"max_error", &QualityRequest::max_error}}};

std::string path_in(const std::string& folder) {
  return (std::filesystem::path(folder) / "bounds.json").string();
}

}  // namespace

QualityRequest load_bounds(const std::string& folder) {
  const auto bytes = read_file(path_in(folder));
  if (!bytes) return {};
  const auto* const text = reinterpret_cast<const char*>(bytes->data());
  const auto json = nlohmann::json::parse(text, text + bytes->size(), nullptr, false);
  QualityRequest bounds;
  for (const auto& [name, member] : kMembers) {
    if (!json.is_object() || !json.contains(name) || !json[name].is_number()) continue;
    const double value = json[name];
    if (std::isfinite(value) && value > 0) bounds.*member = QualityBound{value};
  }
  return bounds;
}

Result<void> save_bounds(const std::string& folder, const QualityRequest& bounds) {
  if (bounds.empty()) return {};
  auto json = nlohmann::json::object();
  for (const auto& [name, member] : kMembers)
    if (bounds.*member) json[name] = (bounds.*member)->value;
  const std::string text = json.dump() + '\n';
  return write_file(path_in(folder), std::as_bytes(std::span(text)));
}

}  // namespace deltamesh::cli
