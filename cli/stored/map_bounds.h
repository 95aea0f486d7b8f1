// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// bounds.json of a map's folder: what was asked when the map was last made or changed.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "deltamesh/attribute_quality.h"
#include "deltamesh/map/encode_map.h"
#include "deltamesh/map/folder.h"
#include "deltamesh/result.h"

namespace deltamesh::cli {

/// How a mesh is split into parts.
struct MapParts {
  std::uint32_t most_triangles = MapSettings{}.most_triangles;
  std::uint8_t levels = 0;
};

inline constexpr std::uint8_t kMostLevels = 21;  ///< the most that MapSettings::levels may be

struct MapBounds {
  QualityRequest asked{};                        ///< as MapState has it
  QualityRequest bounds{};                       ///< likewise
  std::optional<AttributeQuality> attributes{};  ///< what was asked of attributes; empty: nothing
  std::optional<MapParts> parts{};               ///< of `map split`
};

/// Which bounds a command asks for itself.
struct AskedBounds {
  bool of_positions = false;
  bool of_attributes = false;
};

/// Fills `bounds` with what the map in a folder keeps. Where the file is wrong, or is missing and the command
/// does not ask for all bounds itself, says so and leaves the exit code in `status`.
bool load_bounds(const std::string& folder, const MapManifest& manifest, const AskedBounds& asked,
                 MapBounds& bounds, int& status);

/// save_map() together with the bounds.
Result<void> save_map_with_bounds(const std::string& folder, const MapManifest& manifest,
                                  std::span<const NewPart> parts, const MapBounds& bounds);

/// "max error 0.02% = 0.00146, vde 0.01": what was asked of positions, and what it is in model units where
/// that is in percent.
std::string bounds_text(const MapBounds& bounds);

/// "normals 1, colours 4 (rms)": what was asked of attributes, where it is not the default.
std::string attribute_bounds_text(const AttributeQuality& quality);

}  // namespace deltamesh::cli
