// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which meshes of a glTF asset are seen, and where.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/numbers/vec3.h"
#include "io/gltf/document.h"

namespace deltamesh::gltf {

/// Column-major 4 x 4, the last row taken as 0 0 0 1.
struct Transform {
  std::array<double, 16> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

  bool is_identity() const noexcept { return m == Transform{}.m; }
  Vec3 column(std::size_t c) const noexcept { return {m[4 * c], m[4 * c + 1], m[4 * c + 2]}; }
  /// Determinant of the linear part; negative if it mirrors.
  double determinant() const noexcept { return dot(column(0), cross(column(1), column(2))); }
  Vec3 point(const Vec3& p) const noexcept { return direction(p) + column(3); }
  Vec3 direction(const Vec3& d) const noexcept {
    return d[0] * column(0) + d[1] * column(1) + d[2] * column(2);
  }
  /// By the inverse transpose, unit length; `n` itself where that is degenerate.
  Vec3 normal(const Vec3& n) const noexcept;
  /// First `b`, then this.
  Transform operator*(const Transform& b) const noexcept;
};

struct Placement {
  std::size_t mesh = 0;               ///< number
  std::optional<std::size_t> node{};  ///< number; none where there are no nodes
  Transform transform{};
};

/// The meshes of the default scene, or of all scenes where none is the default, or of all root nodes where
/// there are no scenes, or all meshes where there are no nodes; in depth-first order. Instances
/// (EXT_mesh_gpu_instancing) are placed one by one; the node of a skinned mesh does not move it (glTF 2.0,
/// 3.7.3.3). Errors: kInvalidFile: an index without its object, a node that is reached twice, a malformed
/// node, more places than bytes. Cost O(nodes and instances).
Result<std::vector<Placement>> place_meshes(const Document& document);

/// How many nodes with meshes have none of the `placements`, and meshes that no node names.
std::uint64_t hidden_meshes(const Json& json, const std::vector<Placement>& placements);

}  // namespace deltamesh::gltf
