// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Some faces of a mesh, with the vertices that they use.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "deltamesh/mesh.h"

namespace deltamesh {

/// Faces are added one by one and taken as a mesh whose vertices come as faces first use them.
class RowGather {
 public:
  /// The arrays of `source` must outlive this.
  explicit RowGather(MeshView source);

  void add_face(std::size_t face);
  /// The source's vertex of every vertex of the mesh that take() will return.
  const std::vector<std::uint32_t>& rows() const noexcept { return rows_; }
  /// The mesh of the faces added since the last call.
  Mesh take();

 private:
  MeshView source_;
  std::vector<std::uint32_t> number_;  ///< by vertex of the source, of this mesh; kNone where it is not there
  std::vector<std::uint32_t> rows_;    ///< vertices of the source that are there
  std::vector<std::uint32_t> triangles_;
  std::vector<std::uint32_t> groups_;
};

}  // namespace deltamesh
