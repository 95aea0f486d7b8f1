// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The meshes of a run: where they come from, and the form that every peer gets.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh::bench {

/// A mesh that is loaded when its turn comes.
struct MeshSource {
  std::string name;  ///< "paper/bunny_34834"
  std::function<Result<Mesh>()> load;
};

/// The PLY files right in paper/, models/ and robot/ under `folder`, by name; none where there is no such
/// folder.
std::vector<MeshSource> corpus_meshes(const std::string& folder);

/// Our own scenes with about `vertices` vertices each, one seed.
std::vector<MeshSource> generated_meshes(std::uint64_t vertices);

/// The subset of corpus_meshes() that --quick measures.
bool is_quick_mesh(const MeshSource& source);

/// `mesh` without attributes, with equal positions (bit by bit) made one vertex, then without degenerate
/// faces and unused vertices: the same input for every peer. Vertices keep the order of first appearance.
Mesh welded_geometry(const Mesh& mesh);

}  // namespace deltamesh::bench
