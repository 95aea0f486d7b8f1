// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A mesh of an asset, coded by Draco, as KHR_draco_mesh_compression has it: a Draco buffer for each
// primitive. Bytes are those of glTF-Transform 4.5.1, apart from primitives that share vertices (there the
// quantisers' ranges are those of all) and those with morph targets (which that program codes sequentially).
#pragma once

#include "asset/mesh_error.h"
#include "asset/source.h"
#include "deltamesh/result.h"
#include "peers/draco_mesh.h"

namespace deltamesh::bench {

/// 10 - speed.
inline constexpr int kDracoLevel = 10;

/// The primitive in Draco's form, equal values and points merged as its own tools do. Without the attribute
/// `left_out`, counted as in the primitive.
std::unique_ptr<draco::Mesh> merged_draco(const Primitive& primitive,
                                          std::optional<std::size_t> left_out = std::nullopt);

/// Codes all primitives at kDracoLevel and checks that the streams decode to draco_values(). Bytes of an
/// attribute: what the stream has more than one without it. Errors: kInternal.
Result<CodedMesh> code_with_draco(const AssetMesh& mesh, const DracoSetting& setting);

}  // namespace deltamesh::bench
