// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// meshoptimizer's order and codecs, for meshes and for primitives of assets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace deltamesh::bench {

/// Triangles and vertices in the order in which the codecs take fewest bytes.
struct MeshoptOrder {
  std::vector<std::uint32_t> indices;
  std::vector<std::uint32_t> place;  ///< of every vertex
};

MeshoptOrder meshopt_order(std::span<const std::uint32_t> triangles, std::size_t vertices);

/// Appends the vertex stream of rows of `size` bytes (a multiple of 4), put into order; returns its bytes.
std::size_t append_vertices(std::vector<std::byte>& raw, std::span<const std::byte> rows, std::size_t size,
                            const MeshoptOrder& order);

/// Appends the index stream.
void append_indices(std::vector<std::byte>& raw, const MeshoptOrder& order);

}  // namespace deltamesh::bench
