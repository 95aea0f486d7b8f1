// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The input's faces over vertices of different positions, without vertices that are dropped.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/mesh.h"

namespace deltamesh {

inline constexpr std::uint32_t kDropped = 0xffffffff;

/// A flag for every vertex.
std::vector<std::uint8_t> find_referenced(const MeshView& mesh);

struct WeldedMesh {
  /// Geometric vertex of every input vertex, or kDropped; empty where all are kept, each alone.
  std::vector<std::uint32_t> geometric;
  std::vector<std::uint32_t> renumbered;      ///< likewise
  std::span<const std::uint32_t> triangles;   ///< the input's, or those that are renumbered
  std::vector<std::uint32_t> representative;  ///< input vertex of every geometric vertex
  bool has_seams = false;
};

/// `drops`: vertices that are not referenced. The mesh must outlive the result.
WeldedMesh weld_mesh(const MeshView& mesh, const std::vector<std::uint8_t>& referenced, bool drops);

}  // namespace deltamesh
