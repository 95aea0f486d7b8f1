// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A mesh as the surface that distances and angles are taken to.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/vec3.h"
#include "deltamesh/mesh.h"
#include "topology/weld.h"

namespace deltamesh {

/// World positions less `origin`, n.
std::vector<Vec3> positions_relative_to(const std::array<double, 3>& origin, const MeshView& mesh);

/// Vertices without a face belong to the surface only where there is no face at all: a point cloud is the
/// surface made of its points.
struct Surface {
  /// `mesh` has passed check_mesh(); positions are taken relative to `origin`.
  Surface(const MeshView& mesh, const std::array<double, 3>& origin);

  /// First vertex of the same position, for every vertex.
  std::vector<std::uint32_t> weld_groups() const;
  /// Of the box around the vertices that count; model units.
  double diagonal() const;

  std::vector<Vec3> positions;
  std::vector<std::uint8_t> used;        ///< n flags: the vertex counts
  std::vector<std::uint32_t> triangles;  ///< never empty unless there are no vertices
  Weld weld;
  std::vector<Vec3> normals;  ///< n, unit or zero
};

}  // namespace deltamesh
