// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// One part of a map, as a mesh and what is known of its border.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "deltamesh/map/description.h"
#include "deltamesh/map/part_key.h"
#include "deltamesh/mesh.h"

namespace deltamesh {

/// A vertex whose position faces of more than one part have. It is on the map's lattice, with the same bits
/// in every part, whatever the quality [MAP-8].
struct BorderVertex {
  std::uint32_t vertex = 0;  ///< of the part's mesh
  LatticePoint point{};
  /// Tells apart border positions of the map's source that share a lattice point: they are numbered from 0.
  std::uint32_t twin = 0;

  bool operator==(const BorderVertex&) const = default;
};

/// A part before coding, or decoded. Decoded, the border vertices' positions are those of their points;
/// before coding they are still those of the source, so that coders see its regularity.
struct MapPart {
  PartKey key{};
  /// Positions relative to the map's origin, which is mesh.origin too; every vertex is used by a face.
  /// Attributes are those of the map, in its order.
  Mesh mesh{};
  std::vector<BorderVertex> border{};  ///< ascending by vertex
  /// Decoded: where the stream has the border vertices, b x 3; of a part that a patch put together: none.
  std::vector<float> streamed_border{};
};

/// A part's octets are no longer, and it has at most so many vertices and triangles [MAP-7].
inline constexpr std::size_t kMostPartBytes = std::size_t{1} << 16;

}  // namespace deltamesh
