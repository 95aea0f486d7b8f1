// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which attributes the primitives of a glTF asset have in common, and their values in the merged mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "deltamesh/io.h"
#include "io/gltf_accessor.h"
#include "io/gltf_scene.h"

namespace deltamesh {

/// Vertices that one or more primitives of a placed mesh share.
struct GltfVertexSet {
  const std::map<std::string, int>* semantics = nullptr;  ///< of the primitives
  const GltfTransform* transform = nullptr;
  std::uint64_t first = 0;  ///< vertex in the merged mesh
  std::uint64_t count = 0;
};

/// All attributes but the position, of `vertices` vertices. NORMAL, TANGENT and TEXCOORD_n become float32,
/// normals and tangents are turned with their node. Where the sets differ: a colour that some lack is filled
/// with opaque white, tangents with x, the rest with 0 (normals are add_missing_normals()'s to find); colours
/// and weights of several types become float32, joints u16. A custom attribute that a set lacks, or has in
/// another type, and one whose name is not UTF-8 of 1 to 255 bytes, is left out and told to `report`.
/// Errors: kInvalidFile: a semantic with a wrong type or count, accessors out of range.
Result<std::vector<Attribute>> merge_attributes(const GltfDocument& document, GltfBuffers buffers,
                                                const std::vector<GltfVertexSet>& sets,
                                                std::uint64_t vertices, ReadReport& report);

/// Gives the vertices of sets without NORMAL the normals of `mesh`, weighted by area, where it has the
/// attribute for others. `mesh` is complete but for them.
void add_missing_normals(const std::vector<GltfVertexSet>& sets, Mesh& mesh);

}  // namespace deltamesh
