// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The faces of a PLY file: their corners, colours, and the texture coordinates of corners.
#pragma once

#include <cstdint>
#include <vector>

#include "io/ply/body.h"
#include "io/polygons/mesh.h"

namespace deltamesh {

class PlyFaces {
 public:
  /// The face element, of a mesh of `vertices` vertices. Errors: kInvalidFile.
  Result<void> read(PlyBody& body, const PlyElement& face, std::uint64_t vertices);

  /// Colours are left out where `mesh` has some at its vertices.
  void move_into(PolygonMesh& mesh, ReadReport& report);

 private:
  enum class Role : std::uint8_t { kNone, kCorners, kUvs, kColor };

  /// What each property is; `report_` gets those that are nothing.
  void choose_roles(const PlyElement& face);
  Result<void> end_row(const PlyBody& body);

  Faces faces_;
  std::vector<Role> roles_;
  ReadReport report_;
  std::vector<std::uint32_t> corners_;  // of this face
  std::vector<double> face_uvs_;
  std::vector<std::byte> face_color_;
  std::vector<std::uint8_t> components_;  // of the colour, for every property
  Attribute colors_;                      // one per face
  std::vector<std::uint32_t> color_owners_;
  bool has_uvs_ = false;
  Attribute uvs_;  // one per corner that has them
  std::vector<std::uint32_t> uv_owners_;
  std::uint64_t corners_without_uvs_ = 0;
};

}  // namespace deltamesh
