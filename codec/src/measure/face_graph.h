// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The faces of a mesh and which of them meet at an edge, copies of a position taken as one vertex.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/numbers/vec3.h"
#include "deltamesh/mesh.h"

namespace deltamesh {

/// A face across an edge.
struct FaceAcross {
  std::uint32_t face = 0;
  std::uint8_t corner = 0;  ///< of `face`, where the edge begins as `face` goes around
  bool same_way = false;    ///< both faces go along the edge in the same direction
  bool shared = false;      ///< the edge has the same vertices in both, not only the same places
};

/// The first few of them.
struct FacesAcross {
  static constexpr std::size_t kMost = 8;
  std::array<FaceAcross, kMost> faces{};
  std::size_t size = 0;

  const FaceAcross* begin() const noexcept { return faces.data(); }
  bool any_shared() const noexcept {
    return std::any_of(begin(), end(), [](const FaceAcross& face) { return face.shared; });
  }
  const FaceAcross* end() const noexcept { return faces.data() + size; }
};

/// A vertex without a face counts as a face of three equal corners, behind all others.
struct FaceGraph {
  /// `mesh` has passed check_mesh(); positions are taken relative to `origin`. O(n + m).
  FaceGraph(const MeshView& mesh, const std::array<double, 3>& origin);

  std::size_t face_count() const noexcept { return corners.size() / 3; }
  const Vec3& at(std::uint32_t face, std::size_t corner) const noexcept {
    return positions[vertices[3 * std::size_t{face} + corner]];
  }
  /// Whether two corners are at one place.
  bool is_degenerate(std::uint32_t face) const noexcept {
    const std::uint32_t* const c = &corners[3 * std::size_t{face}];
    return c[0] == c[1] || c[1] == c[2] || c[2] == c[0];
  }
  double longest_edge(std::uint32_t face) const noexcept;
  /// Faces around a welded vertex; no more than kMostLooked of them.
  std::span<const std::uint32_t> around(std::uint32_t welded) const noexcept;
  /// Across the edge from `corner` to the next one; none where it has one vertex only. O(1).
  FacesAcross across(std::uint32_t face, std::size_t corner) const noexcept;

  static constexpr std::size_t kMostLooked = 256;

  std::vector<Vec3> positions;          ///< n
  std::vector<std::uint32_t> vertices;  ///< f x 3 vertices
  std::vector<std::uint32_t> corners;   ///< f x 3 welded vertices
  std::vector<Vec3> welded_positions;
  std::size_t real_faces = 0;  ///< those of the mesh

 private:
  std::vector<std::size_t> first_;    ///< welded vertices + 1 places in faces_
  std::vector<std::uint32_t> faces_;  ///< around each welded vertex, ascending
};

}  // namespace deltamesh
