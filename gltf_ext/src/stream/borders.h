// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Borders between streams.
#pragma once

#include <vector>

#include "stream/plan.h"

namespace deltamesh::gltf {

/// Sets `lattice` of streams that have a position in common, to the bit, with another stream of the same mesh
/// or of a mesh that a node with the same transform shows: coded with loss, each on its own, they would come
/// apart there. Errors: as read_corners(), place_meshes().
Result<void> mark_borders(const AccessorStore& store, const std::vector<PrimitiveSource>& sources,
                          std::vector<StreamPlan>& plans);

}  // namespace deltamesh::gltf
