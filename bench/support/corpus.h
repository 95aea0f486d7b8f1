// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a run measures: meshes and assets of the corpus, generated ones, and the form that every peer gets.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh::bench {

/// Something to measure that is loaded when its turn comes.
template <class T>
struct Source {
  std::string name;  ///< "paper/bunny_34834"
  std::function<Result<T>()> load;
};
using MeshSource = Source<Mesh>;

/// $DELTAMESH_CORPUS, else where it may lie beside this repository.
std::string default_corpus();

/// The files right in the folders `groups` of `corpus` with one of the `suffixes` (".ply"), in order; none
/// where there is no such folder.
std::vector<std::filesystem::path> corpus_files(const std::string& corpus,
                                                std::initializer_list<const char*> groups,
                                                std::initializer_list<std::string_view> suffixes);

Result<Mesh> load_mesh(const std::string& path);

/// The PLY files of paper/, models/ and robot/, by name.
std::vector<MeshSource> corpus_meshes(const std::string& corpus);

/// Our own scenes with about `vertices` vertices each, one seed.
std::vector<MeshSource> generated_meshes(std::uint64_t vertices);

/// The subset of corpus_meshes() that --quick measures.
bool is_quick_mesh(const std::string& name);

/// `mesh` without attributes, with equal positions (bit by bit) made one vertex, then without degenerate
/// faces and unused vertices: the same input for every peer. Vertices keep the order of first appearance.
Mesh welded_geometry(const Mesh& mesh);

}  // namespace deltamesh::bench
