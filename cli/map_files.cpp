// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "map_files.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "report/console.h"
#include "report/map.h"

namespace deltamesh::cli {

bool is_map(const std::string& folder) {
  std::error_code ignored;
  return std::filesystem::exists(std::filesystem::path(folder) / "map.dmm", ignored);
}

std::optional<MapManifest> load_manifest(const std::string& folder, int& status) {
  auto manifest = load_map(folder);
  if (manifest) return *std::move(manifest);
  status = fail((std::filesystem::path(folder) / "map.dmm").string(), manifest.error());
  return std::nullopt;
}

std::optional<MapState> load_state(const std::string& folder, int& status) {
  auto manifest = load_manifest(folder, status);
  if (!manifest) return std::nullopt;
  MapState state{.manifest = *std::move(manifest)};
  for (const PartEntry& entry : state.manifest.entries) {
    auto octets = load_part(folder, entry);
    if (!octets) {
      status = fail(folder + ", part of " + key_text(entry.key), octets.error());
      return std::nullopt;
    }
    state.octets.push_back(*std::move(octets));
  }
  return state;
}

}  // namespace deltamesh::cli
