// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A mesh of an asset, coded by Draco.
#pragma once

#include "asset/asset_source.h"
#include "asset/coded_mesh.h"
#include "asset/draco_primitive.h"
#include "deltamesh/result.h"

namespace deltamesh::bench {

/// 10 - speed.
inline constexpr int kDracoLevel = 10;

/// Codes all primitives at kDracoLevel and checks that the streams decode to draco_values(). Bytes of an
/// attribute: what the stream has more than one without it. Errors: kInternal.
Result<CodedMesh> code_with_draco(const AssetMesh& mesh, const DracoSetting& setting);

}  // namespace deltamesh::bench
