// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A mesh as the geometry coders see it: welded, in coding order.
#pragma once

#include <string>

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"
#include "support/welded_mesh.h"

namespace deltamesh::bench {

/// `mesh` must have passed an importer. Positions are relative to its origin.
WeldedMesh in_coding_order(const MeshView& mesh);

/// Errors: those of read_mesh_file.
Result<WeldedMesh> load_in_coding_order(const std::string& path);

}  // namespace deltamesh::bench
