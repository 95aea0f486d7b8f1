// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Bytes of maps in parts, beside those of one stream.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "deltamesh/mesh.h"
#include "map/exchange.h"

namespace deltamesh::bench {

/// Rows of a table: bytes of the map in parts, primers counted, over those of one stream with the same
/// bounds. Of the attributes colours alone stay.
/// `part_edges`: of the largest parts, model units, one row each. Exits where the mesh cannot be encoded.
void print_splits(const std::string& name, Mesh mesh, const Bounds& bounds,
                  const std::vector<double>& part_edges, std::uint32_t most_triangles);

}  // namespace deltamesh::bench
