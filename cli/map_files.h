// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A map's folder, read with messages for people.
#pragma once

#include <optional>
#include <string>

#include "deltamesh/map/encode_map.h"

namespace deltamesh::cli {

/// The number and the frame that a command asks for. Where it does not, a map that is there keeps its own.
struct AskedName {
  std::optional<std::uint64_t> id{};
  std::optional<std::string> frame{};

  /// `before`: of the map that is there; null: there is none, and the settings stay as they are.
  void set_in(MapSettings& settings, const MapDescription* before) const;
};

/// Whether the folder has a manifest.
bool is_map(const std::string& folder);

/// Whether the path is a map's folder, which a command on streams cannot take: says so, and what will do.
bool refuse_map(const std::string& path, const char* instead);

/// Names every part whose file is not there, or not as long as it should be. Returns the exit code.
int check_files(const std::string& folder, const MapManifest& manifest);

/// Reads all parts and names every one whose file does not hold what the manifest says; `mending` is what
/// helps. Whether there is none; `status` becomes the exit code of the worst, if that is above it.
bool check_parts(const std::string& folder, const MapManifest& manifest, const std::string& mending,
                 int& status);

/// Reads and decodes all parts and names every one that is at fault. Returns the exit code of the worst,
/// which is the highest: a damaged part (1) comes before what stops the program itself.
int verify_map(const std::string& folder);

/// On failure print why and leave the exit code in `status`.
std::optional<MapManifest> load_manifest(const std::string& folder, int& status);
/// With the octets of all parts, without bounds.
std::optional<MapState> load_state(const std::string& folder, int& status);

}  // namespace deltamesh::cli
