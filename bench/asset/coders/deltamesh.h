// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A mesh of an asset, coded by deltamesh as `gltf pack` does.
#pragma once

#include <vector>

#include "asset/mesh_error.h"
#include "asset/source.h"
#include "deltamesh/encode.h"
#include "deltamesh/result.h"
#include "stream/mesh.h"

namespace deltamesh::bench {

/// Asks for positions' rms error and every attribute's largest error of `error`; colours exact where they
/// are.
EncodeOptions options_for(const MeshError& error, int effort);

/// What pack_gltf() makes one stream of.
struct StreamSource {
  gltf::StreamMesh merged;
  bool exact_order = false;
};

/// A source for each stream of the packed mesh. Errors: pack_gltf()'s.
Result<std::vector<StreamSource>> stream_sources(const AssetMesh& mesh);

/// The stream, as pack_gltf() makes it of the same options for the asset. Errors: as encode().
Result<Encoded> encode_stream(const StreamSource& source, const EncodeOptions& options);

/// Packs the mesh. Bytes of attributes are those that the streams tell. The errors are measured on the
/// decoded streams; encode_stream() tells the order of their vertices. Errors: pack_gltf()'s, encode()'s,
/// decode()'s; kInternal where encode_stream() does not give the packed streams.
Result<CodedMesh> code_with_deltamesh(const AssetMesh& mesh, const std::vector<StreamSource>& sources,
                                      const EncodeOptions& options);

}  // namespace deltamesh::bench
