// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// ORDR: the input's order of vertices and faces, and the rotation of each face.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

struct MeshOrder {
  std::vector<std::uint32_t>
      vertices;  ///< n: place of every coded vertex in the original order (a permutation of 0 .. n - 1)
  std::vector<std::uint32_t> faces;    ///< m: place of every coded face
  std::vector<std::uint8_t> rotation;  ///< m: which corner of the original face is the coded face's corner 0
};

/// `triangles`: m x 3, as coded. O(n + m).
std::vector<std::byte> write_order(MeshOrder order, std::span<const std::uint32_t> triangles);

/// Errors: kTruncated, kInvalidStream where not a permutation [ORDR-*].
Result<MeshOrder> read_order(std::span<const std::byte> payload, std::span<const std::uint32_t> triangles,
                             std::uint32_t vertex_count);

/// From coded order back to the input's. `order` fits `mesh`: read_order() has checked it. O(size of it).
Mesh restore_order(const Mesh& mesh, const MeshOrder& order);

}  // namespace deltamesh
