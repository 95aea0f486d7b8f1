// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// glTF assets with and without the extension DELTAMESH_mesh_compression. Library target deltamesh::gltf.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// How the result is stored.
enum class GltfContainer : std::uint8_t {
  kGlb,   ///< one binary file
  kGltf,  ///< JSON, its buffer beside it or embedded
};

/// Gives the bytes of an external buffer. `uri` is relative and percent-decoded, and names nothing outside
/// the asset's folder. An error that it returns is handed on.
using GltfResolver = std::function<Result<std::vector<std::byte>>(std::string_view uri)>;

/// Where the bytes come from and go to, the same for packing and unpacking.
struct GltfIo {
  GltfResolver resolve;  ///< empty: an asset with external buffers is refused (kFileOpen)
  GltfContainer container = GltfContainer::kGlb;  ///< of the result
  std::string
      buffer_uri;  ///< kGltf: URI that the result gives its buffer; empty: the buffer is embedded in base64
};

struct GltfPackOptions {
  /// For every mesh; percentages count in its own diagonal. Bounds by name are by semantic ("_HEAT"); those
  /// of POSITION, NORMAL and TANGENT hold for the displacements of morph targets, which get the bounds on
  /// positions, normals (as lengths of the displacement, 1 for 57 degrees) and tangents where none is named.
  /// `progress` tells of the whole asset. The bound on texture coordinates counts behind
  /// KHR_texture_transform. Streams that have positions in common, to the bit, in meshes whose nodes have the
  /// same transform, have them in common decoded too: all get the predictive coder, on a lattice that keeps
  /// the finest bound of theirs; not with `target_bytes`, where meshes may come apart.
  EncodeOptions encode;
  bool fallback = false;  ///< keep plain accessors, holding what the streams decode to, beside the streams
};

/// The attributes of one semantic.
struct GltfAttributeReport {
  std::string semantic;
  bool morph = false;  ///< what morph targets add to it
  AttributeKind kind = AttributeKind::kGeneric;
  std::uint64_t bytes = 0;
  double error = 0;  ///< the largest, see AttributeInfo::error
  double rms = 0;    ///< the largest, see AttributeInfo::rms
};

struct GltfStreamReport {
  StreamInfo info{};
  std::vector<GltfAttributeReport> attributes{};
};

/// What was done, in primitives, vertices and bytes.
struct GltfReport {
  std::uint64_t primitives = 0;     ///< in the asset
  std::uint64_t converted = 0;      ///< compressed, or decompressed
  std::uint64_t streams = 0;        ///< primitives of one mesh share one stream
  std::uint64_t not_triangles = 0;  ///< left as they are: points, lines, no whole triangles, or no positions
  std::uint64_t not_float_positions = 0;  ///< left as they are: positions of a type that glTF does not have
  std::uint64_t otherwise_compressed =
      0;  ///< left as they are: their data is in another extension's or already in this extension's streams
  std::uint64_t not_smaller = 0;            ///< left as they are: packed, they would take more bytes
  std::uint64_t vertices = 0;               ///< in the streams
  std::uint64_t triangles = 0;              ///< in the streams
  std::uint64_t unreferenced_vertices = 0;  ///< of converted primitives, dropped because no face uses them
  /// Dropped because two corners are at one place, so that they draw nothing; kept by lossless, keep_order
  /// and keep_unreferenced.
  std::uint64_t degenerate_triangles = 0;
  std::uint64_t dropped_lengths = 0;  ///< see EncodeReport
  std::uint64_t welded_vertices = 0;  ///< dropped because another vertex is equal in all attributes
  std::uint64_t stream_bytes = 0;
  std::uint64_t input_bytes = 0;   ///< asset and external buffers
  std::uint64_t output_bytes = 0;  ///< asset and external buffer
  // In the result, of what neither packing nor unpacking changes; images that are files of their own do not
  // count:
  std::uint64_t animation_bytes = 0;
  std::uint64_t image_bytes = 0;
  // Only of pack_gltf_file() and unpack_gltf_file(), of what else the asset names, such as images:
  std::uint64_t copied_files = 0;
  std::uint64_t missing_files = 0;  ///< not there to be copied
  // Only of packing:
  double max_error = 0;          ///< largest distance of a vertex from its original, model units of its mesh
  double max_error_percent = 0;  ///< the same in percent of the diagonal of its mesh
  std::vector<GltfAttributeReport> attributes;   ///< over all streams
  std::vector<GltfStreamReport> stream_reports;  ///< in the order of the streams
};

struct GltfOutput {
  std::vector<std::byte> asset;   ///< the .glb or .gltf file
  std::vector<std::byte> buffer;  ///< what belongs at GltfIo::buffer_uri; empty unless that is used
  std::vector<std::string> uris;  ///< relative ones of what else the asset names, such as images
  GltfReport report;
};

/// Compresses every primitive of triangles of `asset` (GLB or JSON, recognised by content), one stream for
/// each mesh; everything else stays as it is, apart from numbers of accessors and buffer views and places in
/// the buffer, and all buffers become one. Primitives whose stream would not save bytes stay plain, unless
/// there is a fallback; GLB chunks that glTF does not define are kept where the result is
/// a GLB. Positions of integers (KHR_mesh_quantization) become floats of the same value; integers of other
/// attributes stay what they are. Triangles of converted primitives may change order, vertices that are equal
/// in all attributes become one unless order or unreferenced vertices are kept, and without `fallback` only a
/// reader that knows the extension can read the result. Errors: kInvalidFile (the element is named where
/// there is one; also if all meshes are compressed by another extension), kInvalidArgument (options),
/// kInvalidMesh and kNotFinite (`where`: the vertex or primitive; `found` names the primitive),
/// kLimitExceeded, kUnmetRequest, kFileOpen, kOutOfMemory, and what `io.resolve` returns.
Result<GltfOutput> pack_gltf(std::span<const std::byte> asset, const GltfPackOptions& options,
                             const GltfIo& io = {}) noexcept;

/// Turns every primitive that has the extension into a plain one and removes the extension. The limits hold
/// for the sum over all streams. Bytes are not trusted. Errors: as pack_gltf(), 1xx for the streams (`where`:
/// byte in the stream), kLimitExceeded.
Result<GltfOutput> unpack_gltf(std::span<const std::byte> asset, const DecodeOptions& options = {},
                               const GltfIo& io = {}) noexcept;

/// The same from file to file. Suffix of `out`: .glb, or .gltf, which gets its buffer in a .bin file of the
/// same name beside it. Where `out` is in another folder than `in`, files that the asset names, such as
/// images, are copied there. Errors: as above, kFileRead, kFileWrite, kUnknownFormat; none is written where a
/// file that the asset names is outside the asset's folder (kInvalidFile), or would replace
/// another file (kFileWrite).
Result<GltfReport> pack_gltf_file(const std::string& in, const std::string& out,
                                  const GltfPackOptions& options = {}) noexcept;
Result<GltfReport> unpack_gltf_file(const std::string& in, const std::string& out,
                                    const DecodeOptions& options = {}) noexcept;

}  // namespace deltamesh
