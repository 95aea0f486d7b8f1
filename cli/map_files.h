// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A map's folder, read with messages for people.
#pragma once

#include <optional>
#include <string>

#include "deltamesh/map/encode_map.h"

namespace deltamesh::cli {

/// Whether the folder has a manifest.
bool is_map(const std::string& folder);

/// On failure print why and leave the exit code in `status`.
std::optional<MapManifest> load_manifest(const std::string& folder, int& status);
/// With the octets of all parts, without bounds.
std::optional<MapState> load_state(const std::string& folder, int& status);

}  // namespace deltamesh::cli
