// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A mesh of an asset, coded by meshoptimizer.
#pragma once

#include <cstdint>

#include "asset/source.h"
#include "deltamesh/result.h"
#include "peers/draco_mesh.h"

namespace deltamesh::bench {

/// Bytes of one zstd frame (level 19) over the vertex and index streams of all primitives: attributes in
/// streams of their own, on the lattices of Draco's quantisers, 16 bits a component. Errors: kInternal.
Result<std::uint64_t> meshopt_bytes(const AssetMesh& mesh, const DracoSetting& setting);

}  // namespace deltamesh::bench
