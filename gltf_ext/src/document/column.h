// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The arrays of a decoded mesh as accessors present them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/mesh.h"
#include "io/gltf/accessor.h"
#include "io/gltf/document.h"

namespace deltamesh::gltf {

/// One array: `shape.count` packed rows, which belong to the mesh or to the caller.
struct Column {
  AccessorShape shape;
  std::span<const std::byte> rows;
  bool is_indices = false;
};

Column position_column(const Mesh& mesh) noexcept;
Column attribute_column(const Mesh& mesh, const Attribute& attribute) noexcept;
/// `bytes`: from index_bytes().
Column index_column(ComponentType type, std::span<const std::byte> bytes) noexcept;

/// The narrower of u16 and u32 that holds every vertex number; the largest value of the type stays unused,
/// for it may mean a restart. Bytes are no indices: current graphics interfaces do not take them.
ComponentType index_type(std::span<const std::uint32_t> corners) noexcept;
std::vector<std::byte> index_bytes(std::span<const std::uint32_t> corners, ComponentType type);

/// Three vertex numbers for each triangle, by group of the triangles; one group where the mesh has none.
std::vector<std::vector<std::uint32_t>> corners_by_group(const Mesh& mesh);

/// Makes the accessor describe `column`: componentType, count, and min and max where it has them or `bounds`
/// asks; its type stays, and is that of indices where it has none. Its data is gone: no view, no sparse part.
void describe_column(Json& accessor, const Column& column, bool bounds);

/// Appends a buffer view with the rows, each padded to a multiple of four bytes where they are vertex data.
std::size_t append_column(Document& document, const Column& column);

}  // namespace deltamesh::gltf
