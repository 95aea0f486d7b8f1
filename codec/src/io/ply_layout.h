// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which property of a PLY vertex goes where in the mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "deltamesh/mesh.h"
#include "io/ply_header.h"

namespace deltamesh {

struct PlyTarget {
  enum class Kind : std::uint8_t { kSkip, kPosition, kAttribute };
  Kind kind = Kind::kSkip;
  std::size_t attribute = 0;   ///< index into PlyVertexLayout::attributes
  std::uint8_t component = 0;  ///< of the position or attribute
};

struct PlyVertexLayout {
  bool has_position = false;
  std::vector<PlyTarget> targets;     ///< one per property
  std::vector<Attribute> attributes;  ///< without values
  std::size_t unnamed = 0;            ///< scalar properties that are skipped for their name
};

/// Finds x y z, normals (nx ny nz), colours (red green blue [alpha], also r g b [a] and diffuse_red ...;
/// uchar, ushort, float or double), texture coordinates (s t, u v, texture_u texture_v, texture_s texture_t);
/// every other scalar property becomes a generic attribute of its own type. Lists, and properties whose name
/// repeats an earlier one or is no attribute name (over 255 bytes, not UTF-8), are skipped.
PlyVertexLayout layout_ply_vertex(const PlyElement& vertex);

}  // namespace deltamesh
