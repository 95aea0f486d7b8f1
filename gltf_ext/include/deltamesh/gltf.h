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
  EncodeOptions encode;   ///< for every primitive; `progress` tells of the whole asset
  bool fallback = false;  ///< keep plain accessors, holding what the streams decode to, beside the streams
};

/// What was done, in primitives, vertices and bytes.
struct GltfReport {
  std::uint64_t primitives = 0;  ///< in the asset
  std::uint64_t converted = 0;   ///< compressed, or decompressed
  std::uint64_t streams = 0;     ///< identical primitives share one stream
  std::uint64_t not_triangles =
      0;  ///< left as they are: points, lines, strips, fans, nothing to draw, or no positions
  std::uint64_t not_float_positions = 0;  ///< left as they are: quantised positions
  std::uint64_t otherwise_compressed =
      0;  ///< left as they are: their data is in another extension's or already in this extension's streams
  std::uint64_t vertices = 0;               ///< in the streams
  std::uint64_t triangles = 0;              ///< in the streams
  std::uint64_t unreferenced_vertices = 0;  ///< of converted primitives, dropped because no face uses them
  std::uint64_t stream_bytes = 0;
  std::uint64_t input_bytes = 0;   ///< asset and external buffers
  std::uint64_t output_bytes = 0;  ///< asset and external buffer
};

struct GltfOutput {
  std::vector<std::byte> asset;   ///< the .glb or .gltf file
  std::vector<std::byte> buffer;  ///< what belongs at GltfIo::buffer_uri; empty unless that is used
  GltfReport report;
};

/// Compresses every triangle-list primitive of `asset` (GLB or JSON, recognised by content) whose positions
/// are float32; everything else stays as it is, apart from numbers of buffer views and places in the buffer,
/// and all buffers become one; GLB chunks that glTF does not define are kept where the result is a GLB.
/// Primitives with morph targets keep the order of their vertices. Triangles of converted primitives may
/// change order, and without `fallback` only a reader that knows the extension can read the result. Errors:
/// kInvalidFile (the element is named where there is one), kInvalidArgument, kInvalidMesh (`where`: the
/// primitive, counted over all meshes), kFileOpen, kOutOfMemory, and what `io.resolve` returns.
Result<GltfOutput> pack_gltf(std::span<const std::byte> asset, const GltfPackOptions& options,
                             const GltfIo& io = {}) noexcept;

/// Turns every primitive that has the extension into a plain one and removes the extension. The limits hold
/// for the sum over all streams. Bytes are not trusted. Errors: as pack_gltf(), 1xx for the streams (`where`:
/// byte in the stream), kLimitExceeded.
Result<GltfOutput> unpack_gltf(std::span<const std::byte> asset, const DecodeOptions& options = {},
                               const GltfIo& io = {}) noexcept;

/// The same from file to file. Suffix of `out`: .glb, or .gltf, which gets its buffer in a .bin file of the
/// same name beside it. Files that the asset names, such as images, are neither copied nor renamed. Errors:
/// as above, kFileRead, kFileWrite, kUnknownFormat.
Result<GltfReport> pack_gltf_file(const std::string& in, const std::string& out,
                                  const GltfPackOptions& options = {}) noexcept;
Result<GltfReport> unpack_gltf_file(const std::string& in, const std::string& out,
                                    const DecodeOptions& options = {}) noexcept;

}  // namespace deltamesh
