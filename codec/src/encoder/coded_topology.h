// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From the input's faces to the coded order of vertices and faces: drop, weld, code the connectivity, split
// at seams.
#pragma once

#include <cstdint>
#include <vector>

#include "connectivity/connectivity.h"
#include "connectivity/order.h"
#include "connectivity/seams.h"
#include "deltamesh/encode.h"
#include "deltamesh/mesh.h"

namespace deltamesh {

struct CodedTopology {
  std::uint64_t unreferenced = 0;              ///< input vertices that no face uses
  CodedConnectivity connectivity;              ///< over geometric vertices
  CodedSeams seams;                            ///< over the vertices that are kept
  std::vector<std::uint32_t> geometric_input;  ///< an input vertex of every coded geometric vertex

  std::uint32_t geometric_count() const noexcept {
    return static_cast<std::uint32_t>(geometric_input.size());
  }
  std::uint32_t vertex_count() const noexcept {
    return static_cast<std::uint32_t>(seams.vertex_order.size());
  }
};

/// `mesh` has passed check_mesh. O(n + m) expected.
CodedTopology code_topology(const MeshView& mesh, bool keep_unreferenced);

/// The ORDR contents that restore the input's order (without dropped vertices). `input_vertices`: of the
/// mesh.
MeshOrder original_order(const CodedTopology& topology, std::size_t input_vertices);

}  // namespace deltamesh
