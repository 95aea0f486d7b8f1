// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What the program says of maps.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "deltamesh/map/folder.h"

namespace deltamesh::cli {

/// Of all parts, ascending.
std::vector<PartKey> keys_of(const MapManifest& manifest);

/// What is told of a map that was made or changed just now.
struct MapUpdate {
  std::size_t new_parts = 0;     ///< coarser copies too
  std::size_t mended_parts = 0;  ///< whose files were missing or damaged
  bool keeps_bounds = false;     ///< those from before
  std::string bounds;            ///< bounds_text()
  bool keeps_attribute_bounds = false;
  std::string attribute_bounds;  ///< attribute_bounds_text(); empty where nothing was asked
  double color_rms = 0;          ///< the mean error that was asked for, 255ths; 0: none, or not known
};

/// For people, on standard output.
void print_map(const std::string& headline, const MapManifest& manifest,
               const std::optional<MapUpdate>& update = std::nullopt);

/// The same figures.
nlohmann::ordered_json map_object(const MapManifest& manifest);

/// Largest distance by which vertices of `mesh` are moved as they become float32 beside the map's origin.
double rounding_in_map(const Mesh& mesh, const MapDescription& description);

struct MapDifference {
  const char* kind;  ///< "new", "changed" or "removed"
  const PartEntry* entry;
};

/// What takes the old map to the new one, ascending by key; the maps must outlive it.
std::vector<MapDifference> map_differences(const MapManifest& before, const MapManifest& after);

/// "level 0, 3 -1 2".
std::string key_text(const PartKey& key);
nlohmann::ordered_json key_object(const PartKey& key);

}  // namespace deltamesh::cli
