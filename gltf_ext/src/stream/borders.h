// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Borders between streams of one mesh.
#pragma once

#include <vector>

#include "stream/plan.h"

namespace deltamesh::gltf {

/// Sets `exact_positions` of streams that have a position in common with another stream of the same mesh:
/// coded apart, and with loss, they would come apart there. Meshes have several streams only where an exact
/// order asks for it. Errors: as read_corners().
Result<void> mark_borders(const AccessorStore& store, const std::vector<PrimitiveSource>& sources,
                          std::vector<StreamPlan>& plans);

}  // namespace deltamesh::gltf
