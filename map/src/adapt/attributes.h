// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A mapper's values of vertices as the map's attributes.
#pragma once

#include <vector>

#include "deltamesh/map/description.h"
#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// The map's attributes with the values of `mesh`, which check_mesh() accepts; see BlockAdapter. Errors:
/// kInvalidMesh naming the attribute of `mesh`, or that of the map which it lacks.
Result<std::vector<Attribute>> adapt_attributes(const MeshView& mesh, const MapDescription& description);

}  // namespace deltamesh
