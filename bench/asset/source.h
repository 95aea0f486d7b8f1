// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The assets of a run, taken apart into their meshes, each in the form that every codec gets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"
#include "support/corpus.h"

namespace deltamesh::bench {

/// Triangles of one primitive and the vertices that they use, attributes by their glTF semantics. Vertices
/// with equal bits are one, unless morph targets count on their numbers.
struct Primitive {
  Mesh mesh;
  bool has_targets = false;
};

/// One mesh of an asset; primitives of the same accessors are one.
struct AssetMesh {
  std::vector<std::byte> asset;  ///< a GLB with this mesh alone
  std::vector<Primitive> primitives;
  std::uint64_t morph_bytes = 0;  ///< of the accessors of morph targets, as they are
};

struct Asset {
  std::string name;
  std::vector<AssetMesh> meshes;  ///< those of the same accessors are one
  std::uint64_t vertices = 0;     ///< of all primitives
};

using AssetSource = Source<Asset>;

/// The GLBs in gltf/ and formats/ under `folder` and formats/Lantern.gltf, by name; none where there is no
/// such folder.
std::vector<AssetSource> corpus_assets(const std::string& folder);

/// A GLB or glTF file, named by its stem.
AssetSource asset_file(const std::string& path);

/// Our own drilled blocks, with normals and texture coordinates.
AssetSource generated_asset(std::uint64_t vertices);

/// The subset of corpus_assets() that --quick measures.
bool is_quick_asset(const std::string& name);

}  // namespace deltamesh::bench
