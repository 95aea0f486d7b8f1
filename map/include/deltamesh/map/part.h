// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// One part of a map, as a mesh and what is known of its border.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "deltamesh/encode.h"
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
};

/// The quality that a part is asked for.
struct PartQuality {
  /// Percent of the diagonal counts in the part's bounding box. `target_bytes` is not for parts. Empty: as
  /// EncodeOptions. No bound on the largest error may be below half the diagonal of a lattice cell.
  QualityRequest bounds{};
  /// Colours of which nothing is said are exact: parts are too small to tell labels from photographs. Ask
  /// ColorContent of the whole map, as encode_map() does.
  AttributeQuality attributes{};
  GeometryCoder geometry = GeometryCoder::kAuto;
  int effort = 1;  ///< 0 to 2
};

struct CodedPart {
  std::vector<std::byte> bytes;            ///< as MapCodec::decode() takes them
  Quality quality{};                       ///< measured on what decode() returns
  std::vector<double> attribute_errors{};  ///< of every attribute, in its kind's unit (AttributeInfo::error)
  double color_rms = 0;                    ///< of red, green and blue of all colours, 255ths
};

/// A part's octets are no longer, and it has at most so many vertices and triangles [MAP-7].
inline constexpr std::size_t kMostPartBytes = std::size_t{1} << 16;

}  // namespace deltamesh
