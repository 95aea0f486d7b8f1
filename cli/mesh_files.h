// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Meshes in and out of files, with messages for people.
#pragma once

#include <optional>
#include <string>

#include "deltamesh/io.h"
#include "exit_codes.h"

namespace deltamesh::cli {

/// Known suffixes, for help and messages.
inline constexpr const char* kMeshSuffixes = ".ply .obj .stl .off .gltf .glb";

/// Reads a mesh; on failure prints why and leaves the exit code in `status`.
std::optional<Imported> load_mesh(const std::string& path, int& status);

/// Reads and decodes a stream, likewise. `threads`: as DecodeOptions.
std::optional<Mesh> load_stream(const std::string& path, int& status, unsigned threads = 1);

/// Either of them, by the suffix.
std::optional<Mesh> load_mesh_or_stream(const std::string& path, int& status);

/// Whether a mesh can be written under this name; if not, says so and which names will do.
bool check_mesh_suffix(const std::string& path, int& status);

/// Whether both paths lead to one regular file, or to one that is yet to be made; an empty path leads
/// nowhere.
bool names_same_file(const std::string& a, const std::string& b);

/// Writes a mesh, whole or not at all; returns the exit code.
int save_mesh(const std::string& path, const MeshView& mesh);

}  // namespace deltamesh::cli
