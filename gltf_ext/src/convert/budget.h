// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Packs one stream after another, and shares a number of bytes between them.
#pragma once

#include <vector>

#include "convert/packer.h"

namespace deltamesh::gltf {

/// All streams as `asked`; its progress tells of all, its bytes are for all together: each gets its share by
/// what it takes without such a limit, or what it needs at least. Errors: as pack_gltf().
Result<std::vector<PackedPrimitive>> pack_streams(StreamPacker& packer, const std::vector<StreamPlan>& plans,
                                                  const EncodeOptions& asked, GltfReport& report);

}  // namespace deltamesh::gltf
