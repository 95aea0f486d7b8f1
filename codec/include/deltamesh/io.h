// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Mesh files: PLY, OBJ, STL, OFF, glTF and GLB. Library target deltamesh::io.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "deltamesh/files.h"
#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

enum class FileFormat : std::uint8_t { kPly, kObj, kStl, kOff, kGltf, kGlb };

/// From the suffix, any letter case. Errors: kUnknownFormat.
Result<FileFormat> format_of_path(std::string_view path) noexcept;

/// What a reader left out or guessed, or what a format cannot hold.
enum class LeftOutKind : std::uint8_t {
  kVertexValues,  ///< an attribute or property of vertices; `count` vertices
  kFaceValues,    ///< of faces or their corners; `count` faces
  kFaces,         ///< `name` tells why
  kPrimitives,    ///< points, lines, curves and the like, meshes that are not shown
  kElements,      ///< PLY: elements that are neither vertices nor faces; OBJ: statements; glTF: parts of the
                  ///< asset
  kNames,      ///< of groups, objects or materials; what had them is kept as far as face groups can tell it
  kPrecision,  ///< digits of values
  kGuesses,    ///< the file contradicts itself or does not say; `name` tells what was taken
};

/// One word for machines: "vertex_values", "face_values", "faces", "primitives", "elements", "names",
/// "precision", "guesses".
std::string_view word_of(LeftOutKind kind) noexcept;

struct LeftOut {
  LeftOutKind kind = LeftOutKind::kElements;
  std::string name;  ///< the file's name for it, or plain words
  std::uint64_t count = 1;
};

/// One phrase for people: "vertex values confidence (1200)".
std::string describe(const LeftOut& entry);

/// What did not get from one side to the other. Empty: nothing is lost.
struct LossReport {
  std::vector<LeftOut> left_out;

  /// Adds to the entry of this kind and name; nothing where `count` is 0.
  void leave_out(LeftOutKind kind, std::string_view name, std::uint64_t count = 1);
};

/// What a reader found in a file, beside the mesh. What makes triangles of a file is no loss, and counted
/// apart.
struct ReadReport : LossReport {
  std::uint64_t polygons = 0;        ///< faces with more than three corners, triangulated
  std::uint64_t welded_corners = 0;  ///< STL: corners merged by equal position
  /// Largest distance of a vertex that faces use from the file's coordinates, which may be double; see
  /// EncodeOptions::source_error.
  double position_error = 0;
  double unused_position_error = 0;  ///< the same of vertices that no face uses
  /// glTF: the largest factor by which a KHR_texture_transform stretches texture coordinates: a bound that is
  /// to hold on textures has to be divided by it.
  double uv_scale = 1;
  std::vector<std::string> files{};  ///< that it names, in its folder: buffers, images, material libraries
};

struct WriteReport : LossReport {};

struct ReadOptions {
  bool drop_invalid = false;  ///< drops faces at vertices that are not finite, in place of keeping them
  std::optional<FileFormat> format{};  ///< of files whose suffix does not say it
};

struct Imported {
  Mesh mesh{};
  ReadReport report{};
  /// The file's coordinates less the mesh's, where rounding to float32 changed any: n x 3, model units, 0 at
  /// vertices that are not finite. For compare(); ReadReport::position_error is the longest.
  std::vector<float> roundings{};
  /// The file's number of every vertex, where some that were not finite were dropped; else empty.
  std::vector<std::uint32_t> file_vertices{};
};

/// Reads a mesh from bytes; objects, groups, materials and solids become groups of faces with names; for
/// kGltf external buffers are resolved against `folder` (never outside it). Vertices that are not finite are
/// dropped where no face uses them. Coordinates that do not fit float32 keep their precision through
/// Mesh::origin. Errors: kInvalidFile with line, byte or element, kLimitExceeded (glTF: JSON nested deeper
/// than 128), kFileOpen and kFileRead (external buffers), kOutOfMemory.
Result<Imported> read_mesh(std::span<const std::byte> bytes, FileFormat format, std::string_view folder = {},
                           const ReadOptions& options = {}) noexcept;

/// Reads the file at `path`; format by suffix, where `options` does not say it. Errors: as above, kFileOpen,
/// kFileRead, kUnknownFormat.
Result<Imported> read_mesh_file(const std::string& path, const ReadOptions& options = {}) noexcept;

/// Writes a mesh to bytes (kGltf: one self-contained JSON with embedded buffers). A mesh with an origin is
/// written with double coordinates where the format has them (PLY, OBJ, OFF), as a node translation in glTF;
/// STL is float32 only. `report`: where to put what the format cannot hold; may be null. Errors: kInvalidMesh
/// (sizes that disagree, index or number of components out of range), kNotFinite (glTF), kLimitExceeded (more
/// than the format or a stream can hold), kOutOfMemory, kUnknownFormat.
Result<std::vector<std::byte>> write_mesh(const MeshView& mesh, FileFormat format,
                                          WriteReport* report = nullptr) noexcept;

/// Writes to `path`, whole or not at all: to a temporary file beside it, then a rename. Format by suffix.
/// Errors: kUnknownFormat, kFileWrite.
Result<void> write_mesh_file(const std::string& path, const MeshView& mesh,
                             WriteReport* report = nullptr) noexcept;

}  // namespace deltamesh
