// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A mesh as the surface that distances and angles are taken to.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/numbers/vec3.h"
#include "deltamesh/mesh.h"
#include "topology/weld.h"

namespace deltamesh {

/// World positions less `origin`, n. `roundings`: what the mesh's positions lack (3 n), or empty.
std::vector<Vec3> positions_relative_to(const std::array<double, 3>& origin, const MeshView& mesh,
                                        std::span<const float> roundings = {});

/// Vertices without a face belong to the surface only where there is no face at all: a point cloud is the
/// surface made of its points.
struct Surface {
  /// `mesh` has passed check_mesh(); the other arguments are as those of positions_relative_to().
  Surface(const MeshView& mesh, const std::array<double, 3>& origin, std::span<const float> roundings = {});

  /// First vertex of the same position, for every vertex.
  std::vector<std::uint32_t> weld_groups() const;
  /// Diagonal of the bounding box of the used vertices, model units; 0 if there are none.
  double diagonal() const;

  std::vector<Vec3> positions;
  std::vector<std::uint8_t> used;        ///< n flags: the vertex counts
  std::vector<std::uint32_t> triangles;  ///< never empty unless there are no vertices
  Weld weld;
  std::vector<Vec3> normals;  ///< n, unit or zero
};

/// `v` at length 1, or zero where it has no direction.
Vec3 unit_or_zero(const Vec3& v) noexcept;

/// One unit normal per vertex: the sum of its triangles' normals, each as long as twice the area; zero where
/// nothing is left of the sum. `group`: n, vertices with one number (below n) share one normal. `triangles`:
/// m x 3 indices below n. O(n + m).
std::vector<Vec3> vertex_normals(std::span<const Vec3> positions, std::span<const std::uint32_t> triangles,
                                 std::span<const std::uint32_t> group);

/// Between two directions, degrees, 0 to 180; accurate near 0.
double angle_degrees(const Vec3& a, const Vec3& b) noexcept;

}  // namespace deltamesh
