// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Mesh files: PLY, OBJ, STL, OFF, glTF and GLB. Library target deltamesh::io.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

enum class FileFormat : std::uint8_t { kPly, kObj, kStl, kOff, kGltf, kGlb };

/// From the suffix, any letter case. Errors: kUnknownFormat.
Result<FileFormat> format_of_path(std::string_view path) noexcept;

/// What an importer found in the file and what it changed.
struct ImportNotes {
  std::uint64_t polygons = 0;          ///< faces with more than three corners, triangulated as fans
  std::uint64_t dropped_faces = 0;     ///< faces with fewer than three corners
  std::uint64_t welded_corners = 0;    ///< STL: corners merged by equal position
  std::uint64_t other_primitives = 0;  ///< glTF: points, lines; PLY, OBJ: edges and the like, left out
  std::uint64_t dropped_attributes =
      0;  ///< name not UTF-8 of 1 to 255 bytes, or glTF primitives differ in it
};

struct Imported {
  Mesh mesh;
  ImportNotes notes;
};

/// Reads a mesh from bytes; for kGltf external buffers are resolved against `folder` (never outside it).
/// Coordinates that do not fit float32 keep their precision through Mesh::origin.
/// Errors: kInvalidFile with line, byte or element, kLimitExceeded (glTF: JSON nested deeper than 128),
/// kFileOpen and kFileRead (external buffers), kOutOfMemory.
Result<Imported> read_mesh(std::span<const std::byte> bytes, FileFormat format,
                           std::string_view folder = {}) noexcept;

/// Reads the file at `path`; format by suffix. Errors: as above, kFileOpen, kFileRead, kUnknownFormat.
Result<Imported> read_mesh_file(const std::string& path) noexcept;

/// Writes a mesh to bytes (kGltf: one self-contained JSON with embedded buffers). A mesh with an origin is
/// written with double coordinates where the format has them (PLY, OBJ, OFF), as a node translation in glTF;
/// STL is float32 only. Errors: kInvalidMesh (sizes that disagree, index out of range; glTF: a coordinate
/// that is not finite), kLimitExceeded (more than the format can hold), kOutOfMemory, kUnknownFormat.
Result<std::vector<std::byte>> write_mesh(const MeshView& mesh, FileFormat format) noexcept;

/// Writes to `path`, whole or not at all: to a temporary file beside it, then a rename. Format by suffix.
/// Errors: kUnknownFormat, kFileWrite.
Result<void> write_mesh_file(const std::string& path, const MeshView& mesh) noexcept;

/// Whole file in, whole file out (same all-or-nothing promise). Errors: kFileOpen, kFileRead, kFileWrite.
Result<std::vector<std::byte>> read_file(const std::string& path) noexcept;
Result<void> write_file(const std::string& path, std::span<const std::byte> bytes) noexcept;

}  // namespace deltamesh
