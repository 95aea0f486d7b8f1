// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The outer layer of a glTF file: GLB chunks, JSON, and the buffers it names.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "deltamesh/result.h"

namespace deltamesh {

struct GltfSource {
  std::string json;                                 ///< only what geometry needs: see open_gltf()
  std::vector<std::span<const std::byte>> buffers;  ///< in the order of the file's "buffers"
  std::vector<std::vector<std::byte>> owned;        ///< buffers that are no part of the file
  std::uint64_t total_bytes = 0;                    ///< the file and all owned buffers
};

/// Takes a glTF or GLB file apart. The JSON is parsed here and written again with nothing but buffer views,
/// accessors, meshes, nodes and scenes, properties of the shapes that the glTF schema gives them: the parser
/// behind parse_gltf_document() recurses over extras and extensions, decodes images and copies buffers, and
/// so never meets any of them. Buffers: the GLB's own, base64 data URIs, or files in `folder` and below (no
/// absolute path, no ".."). `bytes` must outlive the result. Errors: kInvalidFile, kFileOpen, kFileRead.
Result<GltfSource> open_gltf(std::span<const std::byte> bytes, std::string_view folder);

}  // namespace deltamesh
