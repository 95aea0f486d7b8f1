// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A mesh as the geometry coder sees it: position-welded vertices that a face uses, and their graph.
#pragma once

#include <string>
#include <vector>

#include "base/numbers/vec3.h"
#include "deltamesh/mesh.h"
#include "deltamesh/result.h"
#include "topology/adjacency.h"

namespace deltamesh::bench {

struct WeldedMesh {
  std::vector<Vec3> positions;           ///< relative to the mesh's origin
  std::vector<std::uint32_t> triangles;  ///< over `positions`
  Adjacency graph;
  Components components;
  Box box;
};

/// Welds `mesh`; vertices keep their order of first appearance.
WeldedMesh weld(const MeshView& mesh);

/// `welded` with its faces and vertices in the order in which connectivity is coded.
WeldedMesh in_coding_order(const WeldedMesh& welded);

/// Reads the file at `path` and welds it. Errors: those of read_mesh_file.
Result<WeldedMesh> load_welded(const std::string& path);

}  // namespace deltamesh::bench
