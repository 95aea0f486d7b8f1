// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/gltf_accessor.h"

#include <limits>
#include <utility>

#include "base/try.h"

namespace deltamesh {

Result<gltf::AccessorShape> needed_shape(const gltf::Document& document, std::size_t accessor) {
  DELTAMESH_TRY(const auto shape, gltf::accessor_shape(document, accessor));
  if (!shape)
    return gltf::element_error("an accessor of unknown type, or a matrix of padded columns", accessor);
  return *shape;
}

Result<gltf::AccessorRows> needed_rows(const gltf::Document& document, std::size_t accessor) {
  DELTAMESH_TRY(auto rows,
                gltf::read_accessor(document, accessor, std::numeric_limits<std::uint64_t>::max()));
  if (!rows) return gltf::element_error("the accessor's values cannot be read", accessor);
  return *std::move(rows);
}

Result<std::vector<std::uint32_t>> read_indices(const gltf::Document& document, std::size_t accessor,
                                                std::uint64_t vertices) {
  DELTAMESH_TRY(const gltf::AccessorRows rows, needed_rows(document, accessor));
  const gltf::AccessorShape& shape = rows.shape();
  if (shape.components != 1 || (shape.type != ComponentType::kU8 && shape.type != ComponentType::kU16 &&
                                shape.type != ComponentType::kU32))
    return gltf::element_error("indices that are not unsigned integers", accessor);
  std::vector<std::uint32_t> indices(shape.count);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    indices[i] = gltf::read_index(rows.row(i));
    if (indices[i] >= vertices)
      return gltf::element_error("an index names a vertex that does not exist", accessor);
  }
  return indices;
}

}  // namespace deltamesh
