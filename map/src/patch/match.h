// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Finds the faces of a decoded version that are good enough for a newer source.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/attribute_quality.h"
#include "deltamesh/map/part.h"

namespace deltamesh {

/// A version that a receiver has.
struct BaseVersion {
  const MapPart& part;             ///< decoded
  std::span<const float> sources;  ///< of every vertex the position in the source it was encoded from, n x 3
};

struct MatchBounds {
  double max_error = 0;             ///< model units, above 0
  const AttributeQuality& quality;  ///< of colours
};

/// Vertices of the source that are in the base within the bounds, and the faces they make in both. Every
/// vertex that faces of both kinds have is on open edges of either kind.
struct PartMatch {
  bool is_whole() const noexcept { return new_faces.empty() && is_base_whole; }

  std::vector<std::uint8_t> stays;       ///< for every face of the base: 1 if it is one of the source's
  std::vector<std::uint32_t> new_faces;  ///< of the source: those that are not, ascending
  std::vector<std::uint32_t> source_of;  ///< for every vertex of faces that stay, ascending: the source's
  std::vector<std::uint32_t> base_of;    ///< of the source's vertices, or kNotJoined
  bool is_base_whole = false;            ///< all faces of the base stay
};

/// Nothing stays where there are groups of faces or attributes other than colours. O(n log n).
PartMatch match_part(const MapPart& source, const BaseVersion& base, const MatchBounds& bounds);

}  // namespace deltamesh
